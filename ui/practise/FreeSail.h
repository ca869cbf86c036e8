#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/exercise/World.h"

/// Free sailing: an exercise without a mission out of a ship, a place and weather.
namespace sagara::ui {

/// Where a free sail can begin.
struct SailPlace {
    std::string id;  ///< within one list
    std::string name;
    std::string berth;  ///< of the area; empty: at sea
    double along_m = 0.0;
    core::GeoPoint at;
    double heading_deg = 0.0;  ///< true; alongside it follows from the berth
    double depth_m = 0.0;      ///< below chart datum
    struct Line {
        std::string id;
        std::string fairlead;  ///< of the vessel
        std::string bollard;   ///< of the area
    };
    std::vector<Line> lines;  ///< alongside: with which she is made fast, port side to
    bool alongside() const { return !berth.empty(); }
};

/// Places of the area with room and water for that ship: berths long and deep enough, anchorages, open sea.
std::vector<SailPlace> placesFor(const core::Area& area, const core::Vessel& vessel);

struct SailWeather {
    double wind_kn = 10.0;
    double windFrom_deg = 45.0;
    double swell_m = 0.5;  ///< significant height; 0: none
    double swellPeriod_s = 9.0;
    double swellFrom_deg = 225.0;
    double visibility_M = 10.0;
    double rain = 0.0;  ///< 0 to 1
    std::string startUtc = "2027-01-15T03:30:00Z";
};

struct FreeSail {
    std::string shipName;
    std::string vessel;  ///< id of its document
    std::string area;    ///< id of its document
    SailPlace place;
    double heading_deg = 0.0;  ///< at sea
    double speed_kn = 0.0;     ///< at sea, through the water
    SailWeather weather;
    std::string traffic;  ///< "traffic" of another scenario, JSON; empty: none
};

/// The scenario document of it. Its limits are the loader's to check.
std::string freeSailScenario(const FreeSail& sail);

/// A lesson's document in other weather or at another hour.
std::string withWeather(const std::string& scenarioText, const SailWeather& weather);
/// The weather a scenario begins in, before its level changes it.
SailWeather sailWeatherOf(const core::World& world);
/// Peaceful traffic of a scenario's text, as `FreeSail::traffic`.
std::string peacefulTraffic(const std::string& scenarioText);

}  // namespace sagara::ui
