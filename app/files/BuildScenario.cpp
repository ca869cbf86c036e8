#include "app/files/BuildScenario.h"

#include "app/files/FindDocument.h"

namespace sagara::files {

core::Result<std::shared_ptr<const core::World>, std::string> buildScenario(
    const core::DocumentSource& source, const std::string& idOrFile, std::uint64_t seed,
    const ScenarioChanges& changes) {
    const auto scenario = findDocument(source, core::DocumentKind::Scenario, idOrFile);
    if (!scenario) return scenario.error();
    const auto documents = core::collectDocuments({scenario->name, changed(scenario->text, changes)}, source);
    if (!documents) return documents.error().text();
    auto world = core::buildWorld(*documents, seed);
    if (!world) return world.error().text();
    return std::move(world).value();
}

}  // namespace sagara::files
