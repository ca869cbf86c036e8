#include "app/view/ScenarioWorld.h"

#include "app/files/AssetSource.h"
#include "app/files/FindScenario.h"

namespace sagara::view {

core::Result<std::shared_ptr<const core::World>, std::string> worldOf(const ScenarioRequest& request) {
    const files::AssetSource assets(request.assets);
    auto scenario = files::findScenario(assets, request.scenario);
    if (!scenario) return scenario.error();
    const core::NamedText text{scenario->name, files::changed(scenario->text, request.changes)};
    const auto documents = core::collectDocuments(text, assets);
    if (!documents) return documents.error().text();
    auto world = core::buildWorld(*documents, 1);
    if (!world) return world.error().text();
    return std::move(world).value();
}

}  // namespace sagara::view
