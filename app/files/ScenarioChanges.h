#pragma once

#include <optional>
#include <string>

namespace sagara::files {

/// Another hour and other weather for a scenario: the same exercise at night, in fog, in a blow.
struct ScenarioChanges {
    std::optional<std::string> startUtc;  ///< as in 2027-01-15T13:00:00Z
    std::optional<double> wind_kn;
    std::optional<double> visibility_m;
    std::optional<double> rain;  ///< 0 to 1
};

/// The scenario's text with the changes in it. Their limits are the loader's to check; a text that is no JSON
/// stays as it is, and the loader tells.
std::string changed(const std::string& scenarioText, const ScenarioChanges& changes);

}  // namespace sagara::files
