#include "core/exercise/Prediction.h"

#include <algorithm>
#include <cmath>

#include "core/exercise/Advance.h"

namespace sagara::core {
namespace {

/// The same ships in a steady wind on still water, alone.
State undisturbed(State state) {
    for (TargetState& target : state.targets) target.present = false;
    state.weather.sea = {};
    state.weather.now.wind.gustiness = 0.0;
    state.weather.rampFrom_tick = state.weather.rampTo_tick = 0;  // what is on its way is not foreseen
    std::fill(state.fired.begin(), state.fired.end(), std::uint8_t{1});
    state.assessment.closed = true;
    return state;
}

}  // namespace

std::vector<PredictedPose> predict(const World& world, const State& now, std::size_t ship, double seconds,
                                   double every_s) {
    State ahead = undisturbed(now);
    const auto end = ahead.tick + std::llround(seconds * kTicksPerSecond);
    const auto every = std::max<std::int64_t>(1, std::llround(every_s * kTicksPerSecond));
    std::vector<PredictedPose> poses;
    while (ahead.tick <= end && !ahead.stopped && !ahead.ships[ship].aground) {
        const ShipMotion& m = ahead.ships[ship].motion;
        if ((ahead.tick - now.tick) % every == 0)
            poses.push_back({ahead.time(), m.position(), m.heading_rad});
        (void)advance(world, ahead);
    }
    return poses;
}

}  // namespace sagara::core
