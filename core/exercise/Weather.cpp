#include "core/exercise/Weather.h"

#include <algorithm>

#include "core/base/Angle.h"
#include "core/base/SimTime.h"

namespace sagara::core {
namespace {

double mix(double a, double b, double f) { return a + f * (b - a); }
double mixAngle(double a_rad, double b_rad, double f) { return wrapTwoPi(a_rad + f * wrapPi(b_rad - a_rad)); }

WaveSystem mixed(const WaveSystem& a, const WaveSystem& b, double f) {
    // A system that was not there grows in its own shape, one that ends keeps its own.
    if (a.significantHeight_m == 0.0 || b.significantHeight_m == 0.0) {
        WaveSystem only = a.significantHeight_m == 0.0 ? b : a;
        only.significantHeight_m = mix(a.significantHeight_m, b.significantHeight_m, f);
        return only;
    }
    return {mix(a.significantHeight_m, b.significantHeight_m, f), mix(a.peakPeriod_s, b.peakPeriod_s, f),
            mix(a.gamma, b.gamma, f), mixAngle(a.wavesTo_rad, b.wavesTo_rad, f),
            mix(a.spreading, b.spreading, f)};
}

void raise(WeatherState& state, const WaveTable& waves, std::span<const SeaSystem> ownSea) {
    const Weather& now = state.now;
    state.sea.systems.clear();
    auto wind = windSea(now.wind.speed_mps, now.wind.windFrom_rad, now.exposure);
    if (wind && now.windSea > 0.0) {
        wind->significantHeight_m *= now.windSea;
        state.sea.systems.push_back(*wind);
    }
    for (SeaSystem system : ownSea) {
        system.significantHeight_m *= now.ownSea;
        if (system.significantHeight_m > 0.0) state.sea.systems.push_back(system);
    }
    for (const WaveSystem& swell : now.swells) {
        if (swell.significantHeight_m > 0.0) state.sea.systems.push_back(swell);
    }
    raiseSea(waves, state.sea);
}

}  // namespace

Weather scaled(const Weather& base, const LevelPreset& level) {
    Weather w = base;
    w.wind.speed_mps *= level.windFactor;
    for (WaveSystem& swell : w.swells) swell.significantHeight_m *= level.seaFactor;
    w.ownSea *= level.seaFactor;
    w.visibility_m *= level.visibilityFactor;
    return w;
}

Weather unscaled(const Weather& weather, const LevelPreset& level) {
    return scaled(weather, {1.0 / level.windFactor, 1.0 / level.seaFactor, 1.0 / level.visibilityFactor});
}

Weather mixed(const Weather& from, const Weather& to, double fraction) {
    const double f = std::clamp(fraction, 0.0, 1.0);
    Weather w = to;
    w.wind.speed_mps = mix(from.wind.speed_mps, to.wind.speed_mps, f);
    w.wind.windFrom_rad = mixAngle(from.wind.windFrom_rad, to.wind.windFrom_rad, f);
    w.wind.gustiness = mix(from.wind.gustiness, to.wind.gustiness, f);
    for (std::size_t i = 0; i < kMostSwells; ++i) w.swells[i] = mixed(from.swells[i], to.swells[i], f);
    w.current = from.current + f * (to.current - from.current);
    w.visibility_m = mix(from.visibility_m, to.visibility_m, f);
    w.rain = mix(from.rain, to.rain, f);
    w.windSea = mix(from.windSea, to.windSea, f);
    w.ownSea = mix(from.ownSea, to.ownSea, f);
    return w;
}

WeatherState startWeather(const Weather& base, const LevelPreset& level, const WaveTable& waves,
                          std::span<const SeaSystem> ownSea) {
    WeatherState state;
    state.base = base;
    state.from = state.to = state.now = scaled(base, level);
    raise(state, waves, ownSea);
    return state;
}

void changeWeather(WeatherState& state, const Weather& base, const LevelPreset& level, std::int64_t tick,
                   double ramp_s) {
    state.base = base;
    state.from = state.now;
    state.to = scaled(base, level);
    state.rampFrom_tick = tick;
    state.rampTo_tick = tick + std::max<std::int64_t>(1, static_cast<std::int64_t>(ramp_s * kTicksPerSecond));
}

void runWeather(WeatherState& state, const WaveTable& waves, std::int64_t tick,
                std::span<const SeaSystem> ownSea) {
    const bool ended = tick == state.rampTo_tick;
    const bool running = tick > state.rampFrom_tick && tick < state.rampTo_tick;
    if (!ended && !(running && tick % kTicksPerSecond == 0)) return;
    const auto whole = static_cast<double>(state.rampTo_tick - state.rampFrom_tick);
    if (whole <= 0.0) return;
    state.now = mixed(state.from, state.to, static_cast<double>(tick - state.rampFrom_tick) / whole);
    raise(state, waves, ownSea);
}

}  // namespace sagara::core
