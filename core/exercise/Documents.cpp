#include "core/exercise/Documents.h"

#include <set>

#include "core/base/Config.h"
#include "core/exercise/ScenarioVersion.h"

namespace sagara::core {

const char* documentKindName(DocumentKind kind) {
    switch (kind) {
        case DocumentKind::Vessel:
            return "vessel";
        case DocumentKind::Area:
            return "area";
        case DocumentKind::Scenario:
            return "scenario";
        case DocumentKind::Picture:
            return "picture";
    }
    return "";
}

Result<ExerciseDocuments, config::Problems> collectDocuments(NamedText scenario,
                                                             const DocumentSource& source) {
    config::Document document(scenario.name, scenario.text);
    if (!document.isKind("scenario", kScenarioDocumentVersion)) return document.problems();
    ExerciseDocuments all;
    all.hulls = source.hulls();
    const auto take = [&](config::Reader& in, const char* key,
                          DocumentKind kind) -> std::optional<NamedText> {
        const std::string id = in.id(key);
        if (id.empty()) return std::nullopt;
        auto text = source.find(kind, id);
        if (!text) {
            in.problem(key, "names \"" + id + "\", which is not known",
                       "the id of " + std::string(documentKindName(kind)) +
                           (kind == DocumentKind::Picture ? " in assets/pictures" : " in the database"));
            return std::nullopt;
        }
        return NamedText{id, std::move(*text)};
    };
    config::Reader in(document.root());
    if (auto area = take(in, "area", DocumentKind::Area)) all.area = std::move(*area);
    std::set<std::string> taken;
    for (const config::Node& node : in.list("ownShips")) {
        config::Reader ship(node);
        auto vessel = take(ship, "vessel", DocumentKind::Vessel);
        if (vessel && taken.insert(vessel->name).second) all.vessels.push_back(std::move(*vessel));
    }
    for (const config::Node& node : in.listOr("traffic")) {
        config::Reader target(node);
        if (target.has("picture")) take(target, "picture", DocumentKind::Picture);
    }
    if (!document.problems().empty()) return document.problems();
    all.scenario = std::move(scenario);
    return all;
}

}  // namespace sagara::core
