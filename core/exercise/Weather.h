#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/sea/Beaufort.h"
#include "core/sea/SeaState.h"
#include "core/sea/Wind.h"

namespace sagara::core {

inline constexpr std::size_t kMostSwells = 2;

/// The weather of an exercise, as a trainer writes it. The wind sea follows from the wind, unless the
/// scenario has a sea of its own; once a trainer orders wind, the sea follows it again.
struct Weather {
    WindParameters wind;
    Exposure exposure = Exposure::Inshore;
    std::array<WaveSystem, kMostSwells> swells;  ///< height 0: none
    NorthEast current;                           ///< where it sets, m/s
    double visibility_m = 20'000.0;
    double rain = 0.0;     ///< 0 none to 1 heavy
    double windSea = 1.0;  ///< factor on the height of the sea that follows from the wind
    double ownSea = 0.0;   ///< factor on the height of the scenario's own sea (World::sea)

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.wind, self.exposure, self.swells, self.current, self.visibility_m, self.rain, self.windSea,
           self.ownSea);
    }
};

/// How a level of difficulty changes the weather.
struct LevelPreset {
    double windFactor = 1.0;
    double seaFactor = 1.0;
    double visibilityFactor = 1.0;
};

/// Weather and sea of this moment and where they are going. Part of State.
struct WeatherState {
    Weather base;  ///< as ordered, before the level scales it
    Weather from;
    Weather to;
    Weather now;
    std::int64_t rampFrom_tick = 0;
    std::int64_t rampTo_tick = 0;
    SeaState sea;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.base, self.from, self.to, self.now, self.rampFrom_tick, self.rampTo_tick, self.sea);
    }
};

Weather scaled(const Weather& base, const LevelPreset& level);
/// The base that scales to this weather.
Weather unscaled(const Weather& weather, const LevelPreset& level);
/// Directions turn the short way.
Weather mixed(const Weather& from, const Weather& to, double fraction);

/// Weather at the start, at once.
WeatherState startWeather(const Weather& base, const LevelPreset& level, const WaveTable& waves,
                          std::span<const SeaSystem> ownSea = {});
/// Begins a ramp from what is to `base` at this level.
void changeWeather(WeatherState& state, const Weather& base, const LevelPreset& level, std::int64_t tick,
                   double ramp_s);
/// Moves a running ramp on; the sea is raised anew once a second.
void runWeather(WeatherState& state, const WaveTable& waves, std::int64_t tick,
                std::span<const SeaSystem> ownSea = {});

}  // namespace sagara::core
