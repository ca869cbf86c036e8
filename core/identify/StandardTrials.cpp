#include "core/identify/StandardTrials.h"

#include "core/identify/TrialShip.h"

namespace sagara::core {

bool StandardTrials::cancelled() const {
    for (const Trial* trial : {&turnStarboard, &turnPort, &zigzag10, &zigzag20, &stop})
        if (trial->end == TrialEnd::Cancelled) return true;
    return false;
}

StandardTrials runStandardTrials(const Vessel& vessel, const TrialsWatch& watch, std::string_view model,
                                 double depth_m) {
    constexpr double kRuns = 5.0;
    TrialShip ship(vessel, model, depth_m);
    StandardTrials trials;
    TrialOptions options;
    options.approach = ship.fullAhead();
    double done = 0.0;
    const auto run = [&](Trial& trial, const char* title, auto&& manoeuvre) {
        if (trials.cancelled()) {
            trial.end = TrialEnd::Cancelled;
            return;
        }
        if (watch) options.watch = [&](double share) { return watch((done + share) / kRuns, title); };
        trial = manoeuvre();
        done += 1.0;
    };
    const double limit_rad = std::min(35.0 * kDegree_rad, vessel.steering.limit_rad);
    run(trials.turnStarboard, "Turning circle to starboard",
        [&] { return runTurningCircle(ship, {.rudder_rad = limit_rad}, options); });
    run(trials.turnPort, "Turning circle to port",
        [&] { return runTurningCircle(ship, {.rudder_rad = -limit_rad}, options); });
    run(trials.zigzag10, "Zigzag 10/10", [&] { return runZigzag(ship, {}, options); });
    run(trials.zigzag20, "Zigzag 20/20", [&] {
        return runZigzag(ship, {.rudder_rad = 20.0 * kDegree_rad, .switch_rad = 20.0 * kDegree_rad}, options);
    });
    run(trials.stop, "Stopping", [&] { return runCrashStop(ship, {}, options); });
    return trials;
}

std::array<double, kTelegraphSteps> telegraphSpeeds_mps(const Vessel& vessel, std::string_view model) {
    TrialShip ship(vessel, model);
    std::array<double, kTelegraphSteps> speeds{};
    for (std::size_t i = 0; i < kTelegraphSteps; ++i) {
        const double shaft_rps = vessel.propulsion.telegraph_rps[i];
        if (shaft_rps == 0.0) continue;
        ship.begin({});
        speeds[i] = ship.steadyAt(shaft_rps).speed_mps;
    }
    return speeds;
}

}  // namespace sagara::core
