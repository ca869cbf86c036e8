#include "app/files/ScenarioChanges.h"

#include <nlohmann/json.hpp>

#include "core/base/Units.h"

namespace sagara::files {

std::string changed(const std::string& scenarioText, const ScenarioChanges& c) {
    if (!c.startUtc && !c.wind_kn && !c.visibility_m && !c.rain) return scenarioText;
    auto document = nlohmann::json::parse(scenarioText, nullptr, false);
    if (!document.is_object()) return scenarioText;
    if (c.startUtc) document["startUtc"] = *c.startUtc;
    auto& weather = document["weather"];
    if (!weather.is_object()) return scenarioText;
    if (c.wind_kn) {
        if (!weather["wind"].is_object()) return scenarioText;
        weather["wind"]["speed_kn"] = *c.wind_kn;
    }
    if (c.visibility_m) weather["visibility_M"] = *c.visibility_m / core::kNauticalMile_m;
    if (c.rain) weather["rain"] = *c.rain;
    return document.dump();
}

}  // namespace sagara::files
