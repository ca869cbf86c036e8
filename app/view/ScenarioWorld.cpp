#include "app/view/ScenarioWorld.h"

#include "app/files/AssetSource.h"
#include "app/files/BuildScenario.h"

namespace sagara::view {

core::Result<std::shared_ptr<const core::World>, std::string> worldOf(const ScenarioRequest& request) {
    return files::buildScenario(files::AssetSource(request.assets), request.scenario, 1, request.changes);
}

}  // namespace sagara::view
