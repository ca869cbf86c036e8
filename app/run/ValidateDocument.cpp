#include "app/run/ValidateDocument.h"

#include "app/files/Files.h"
#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "core/base/Config.h"
#include "core/exercise/OrderDocument.h"
#include "core/exercise/Replay.h"
#include "core/identify/TrialTrip.h"
#include "core/sea/BuoySpectrum.h"
#include "render/wall/Layout.h"

namespace sagara::run {
namespace {

using core::config::Problems;

/// The problems of a loader's result; none when it loaded.
template <typename T>
Problems problemsOf(const core::Result<T, Problems>& loaded) {
    return loaded ? Problems() : loaded.error();
}

/// A picture's model must be among the assets; whether it can be read is seen where it is drawn.
void checkModel(Problems& problems, const char* path, const core::Picture& picture) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(files::assetFolder() / "models" / picture.model, ignored)) return;
    problems.add({path, "names \"" + picture.model + "\", which is not there", "a file in assets/models"});
}

Problems checkVessel(const std::string& name, const std::string& text) {
    const auto vessel = core::loadSeaworthy(name, text);
    if (!vessel) return vessel.error();
    Problems problems(name);
    if (vessel->picture) checkModel(problems, "picture.model", *vessel->picture);
    return problems;
}

Problems checkPicture(const std::string& name, const std::string& text) {
    const auto picture = core::loadPicture(name, text);
    if (!picture) return picture.error();
    Problems problems(name);
    checkModel(problems, "model", *picture);
    return problems;
}

core::Result<std::shared_ptr<const core::World>, Problems> worldOf(const Store& store,
                                                                   core::NamedText scenario) {
    const auto documents = core::collectDocuments(std::move(scenario), store);
    if (!documents) return documents.error();
    return core::buildWorld(*documents, 1, core::WorldUse::Look);
}

/// Commands and rubrics are read against the scenario they name.
template <typename Check>
Problems checkAgainstScenario(const Store& store, const std::string& name, const std::string& text,
                              Check&& check) {
    core::config::Document document(name, text);
    core::config::Reader in(document.root());
    const std::string id = in.id("scenario");
    auto scenario = store.find(core::DocumentKind::Scenario, id);
    if (!id.empty() && !scenario) in.problem("scenario", "is \"" + id + "\"", "a scenario in the database");
    if (!document.problems().empty()) return document.problems();
    const auto world = worldOf(store, {id, std::move(*scenario)});
    if (!world) return world.error();
    return check(**world);
}

Problems check(const Store& store, const std::string& name, const std::string& text) {
    enum class Kind { Vessel, Area, Scenario, Commands, Rubric, Wall, Picture, Waves };
    core::config::Document document(name, text);
    core::config::Reader in(document.root());
    const auto kind = in.choiceIfKnown<Kind>("document", {{"vessel", Kind::Vessel},
                                                          {"area", Kind::Area},
                                                          {"scenario", Kind::Scenario},
                                                          {"commands", Kind::Commands},
                                                          {"rubric", Kind::Rubric},
                                                          {"wall", Kind::Wall},
                                                          {"picture", Kind::Picture},
                                                          {"waves", Kind::Waves}});
    if (!kind) return document.problems();
    switch (*kind) {
        case Kind::Vessel:
            return checkVessel(name, text);
        case Kind::Area:
            return problemsOf(core::loadArea(name, text));
        case Kind::Scenario:
            return problemsOf(worldOf(store, {name, text}));
        case Kind::Commands:
            return checkAgainstScenario(store, name, text, [&](const core::World& world) {
                return problemsOf(core::loadCommands(name, text, core::orderNames(world)));
            });
        case Kind::Rubric:
            return checkAgainstScenario(store, name, text, [&](const core::World& world) {
                return problemsOf(core::loadRubric(name, text, world));
            });
        case Kind::Wall:
            return problemsOf(wall::loadLayout(name, text));
        case Kind::Picture:
            return checkPicture(name, text);
        case Kind::Waves:
            return problemsOf(core::loadBuoyRecords(name, text));
    }
    return Problems(name);
}

}  // namespace

int validateDocument(const Store& store, const std::filesystem::path& path) {
    const auto text = files::readTextFile(path);
    if (!text) return tell(text.error().message), kBadRequest;
    const Problems problems = check(store, path.string(), *text);
    if (!problems.empty()) return tell(problems.text()), kBadRequest;
    print(path.string() + ": no problems\n");
    return kDone;
}

}  // namespace sagara::run
