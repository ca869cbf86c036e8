#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "app/files/ScenarioChanges.h"
#include "core/exercise/World.h"

namespace sagara::view {

/// A shipped scenario as it is, or with another time of day and other weather.
struct ScenarioRequest {
    std::filesystem::path assets;
    std::string scenario;  ///< file, or id in assets/scenarios
    int level = 3;
    files::ScenarioChanges changes;
};

/// An error lists all problems of the documents.
core::Result<std::shared_ptr<const core::World>, std::string> worldOf(const ScenarioRequest& request);

}  // namespace sagara::view
