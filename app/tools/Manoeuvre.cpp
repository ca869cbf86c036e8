#include "app/tools/Manoeuvre.h"

#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "app/tools/Table.h"
#include "core/base/Units.h"
#include "core/identify/CrashStop.h"
#include "core/identify/TrialShip.h"
#include "core/identify/TurningCircle.h"
#include "core/identify/Zigzag.h"

namespace sagara::tools {
namespace {

core::TrialOptions trialOptions(core::TrialShip& ship, const ManoeuvreOptions& o) {
    core::TrialOptions options;
    options.approach = o.speed_mps ? ship.holding(*o.speed_mps) : ship.fullAhead();
    if (o.shaft_rps) options.approach->shaft_rps = *o.shaft_rps;
    options.duration_s = o.duration_s;
    options.sample_s = o.dt_s;
    if (o.dt_s) options.step_s = std::min(options.step_s, *o.dt_s);
    return options;
}

core::Trial runTest(core::TrialShip& ship, const ManoeuvreOptions& o) {
    using Test = ManoeuvreOptions::Test;
    const core::TrialOptions options = trialOptions(ship, o);
    const double rudder_rad = o.rudder_deg * core::kDegree_rad;
    switch (o.test) {
        case Test::Turning:
            return core::runTurningCircle(ship, {.rudder_rad = rudder_rad}, options);
        case Test::Zigzag:
            return core::runZigzag(
                ship,
                {.rudder_rad = rudder_rad,
                 .switch_rad = o.heading_deg ? *o.heading_deg * core::kDegree_rad : std::abs(rudder_rad),
                 .starboardFirst = o.starboardFirst},
                options);
        default:
            return core::runCrashStop(ship, {}, options);
    }
}

std::string measuresOf(const core::Trial& trial) {
    Table table({"name", "value"});
    for (const core::TrialMeasure& m : trial.measures) table.add(m.name, m.value);
    return table.text();
}

}  // namespace

int runManoeuvre(const run::Store& store, const ManoeuvreOptions& o) {
    const auto vessel = openVessel(store, o.ship);
    if (!vessel) return run::tell(vessel.error()), run::kBadRequest;
    core::TrialShip ship(*vessel);
    const core::Trial trial = runTest(ship, o);
    if (!o.measures) return writeResult(o.csv, core::trialCsv(trial));
    const int code = o.csv == "-" ? run::kDone : writeResult(o.csv, core::trialCsv(trial));
    run::print(measuresOf(trial));
    return code;
}

}  // namespace sagara::tools
