#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/exercise/Snapshot.h"

namespace sagara::view {

/// A scenario as it is, or with another time of day and other weather.
struct ScenarioRequest {
    std::filesystem::path assets;
    std::string scenario;  ///< file, or id in assets/scenarios
    int level = 3;
    std::optional<std::string> startUtc;
    std::optional<double> wind_kn;
    std::optional<double> visibility_m;
    std::optional<double> rain;
};

/// The folder assets/ of this installation: beside the program where it is installed, else in the source
/// tree.
std::filesystem::path assetFolder();

/// An error lists all problems of the documents.
core::Result<std::shared_ptr<const core::World>, std::string> worldOf(const ScenarioRequest& request);

/// The exercise after so many seconds with the scripted pilot at the helm.
std::shared_ptr<const core::Snapshot> sailed(const std::shared_ptr<const core::World>& world, int level,
                                             double until_s);

}  // namespace sagara::view
