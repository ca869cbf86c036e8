#include "app/tools/Manoeuvre.h"

#include <cmath>

#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "app/tools/TrialResult.h"
#include "core/base/Units.h"
#include "core/identify/CrashStop.h"
#include "core/identify/Pullout.h"
#include "core/identify/ReverseSpiral.h"
#include "core/identify/Spiral.h"
#include "core/identify/TrialShip.h"
#include "core/identify/TurningCircle.h"
#include "core/identify/Zigzag.h"

namespace sagara::tools {
namespace {

double usualRudder_deg(ManoeuvreOptions::Test test) {
    using Test = ManoeuvreOptions::Test;
    switch (test) {
        case Test::Turning:
            return 35.0;
        case Test::Zigzag:
            return 10.0;
        case Test::Spiral:
        case Test::ReverseSpiral:
            return 25.0;
        case Test::Pullout:
            return 20.0;
        case Test::Stopping:
            break;
    }
    return 0.0;
}

core::Approach approachOf(core::TrialShip& ship, const ManoeuvreOptions& o) {
    if (o.speed_mps && o.shaft_rps && *o.shaft_rps > 0.0) return {*o.speed_mps, *o.shaft_rps};
    if (o.speed_mps) return ship.holding(*o.speed_mps);
    return o.shaft_rps && *o.shaft_rps > 0.0 ? ship.steadyAt(*o.shaft_rps) : ship.fullAhead();
}

core::TrialOptions trialOptions(core::TrialShip& ship, const ManoeuvreOptions& o) {
    core::TrialOptions options;
    options.approach = approachOf(ship, o);
    options.duration_s = o.duration_s;
    takeRows(options, o.dt_s);
    return options;
}

}  // namespace

core::Trial tryManoeuvre(const core::Vessel& vessel, const ManoeuvreOptions& o) {
    core::TrialShip ship(vessel, o.ship.model, o.ship.depth_m);
    using Test = ManoeuvreOptions::Test;
    const core::TrialOptions options = trialOptions(ship, o);
    const double rudder_rad = o.rudder_deg.value_or(usualRudder_deg(o.test)) * core::kDegree_rad;
    switch (o.test) {
        case Test::Turning:
            return core::runTurningCircle(ship, {.rudder_rad = rudder_rad}, options);
        case Test::Zigzag:
            return core::runZigzag(
                ship,
                {.rudder_rad = std::abs(rudder_rad),
                 .switch_rad = o.heading_deg ? *o.heading_deg * core::kDegree_rad : std::abs(rudder_rad),
                 .starboardFirst = o.starboardFirst.value_or(rudder_rad >= 0.0),
                 .look_s = o.look_s},
                options);
        case Test::Spiral:
            return core::runSpiral(ship, {.rudder_rad = rudder_rad}, options);
        case Test::ReverseSpiral:
            return core::runReverseSpiral(ship, {.rudder_rad = rudder_rad}, options);
        case Test::Pullout:
            return core::runPullout(ship, {.rudder_rad = rudder_rad}, options);
        case Test::Stopping:
            break;
    }
    return core::runCrashStop(ship, {.rudder_rad = rudder_rad}, options);
}

int runManoeuvre(const run::Store& store, const ManoeuvreOptions& o) {
    const auto vessel = openVessel(store, o.ship);
    if (!vessel) return run::tell(vessel.error()), run::kBadRequest;
    const core::Trial trial = tryManoeuvre(*vessel, o);
    return writeTrial(*vessel, trial, core::trialCsv(trial), o.measures, o.csv);
}

}  // namespace sagara::tools
