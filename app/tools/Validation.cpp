#include "app/tools/Validation.h"

#include <algorithm>

#include "app/files/Files.h"

namespace sagara::tools {

std::vector<std::string> validationIds(const std::filesystem::path& folder) {
    std::vector<std::string> ids;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
        if (entry.path().extension() == ".json") ids.push_back(entry.path().stem().string());
    std::sort(ids.begin(), ids.end());
    return ids;
}

core::Result<ValidationResult, core::config::Problems> runValidation(const ValidationContext& context,
                                                                     const std::string& id) {
    const auto text = files::readTextFile(context.folder / (id + ".json"));
    if (!text) {
        core::config::Problems problems(id);
        problems.add({"", text.error().message, "a case in " + context.folder.string()});
        return problems;
    }
    core::config::Document document(id, *text);
    if (!document.isKind("validation", 1)) return document.problems();
    core::config::Reader in(document.root());
    in.text("document");
    in.integer("version", 1, 1);
    ValidationResult result{id, in.text("title"), {}, in.text("source"), {}, {}};
    result.evidence = in.choice<const char*>(
        "evidence", {{"verification", "verification"}, {"validation", "validation"}, {"trend", "trend"}});
    result.note = in.textOr("note", "");
    if (const auto run = in.choiceIfKnown<RunCase>("kind", {{"decay", runDecayCase},
                                                            {"hydrostatics", runHydrostaticsCase},
                                                            {"ikeda", runIkedaCase},
                                                            {"longWaves", runLongWavesCase},
                                                            {"manoeuvre", runManoeuvreCase},
                                                            {"models", runModelsCase},
                                                            {"propulsion", runPropulsionCase},
                                                            {"rao", runRaoCase},
                                                            {"roll", runRollCase},
                                                            {"spectra", runSpectraCase},
                                                            {"squat", runSquatCase},
                                                            {"timeDomain", runTimeDomainCase},
                                                            {"transfer", runTransferCase},
                                                            {"waves", runWavesCase},
                                                            {"wind", runWindCase}}))
        result.outcome = (*run)(context, in);
    return document.finish(std::move(result));
}

}  // namespace sagara::tools
