#include "app/tools/DecayTool.h"

#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "app/tools/Table.h"
#include "app/tools/TrialResult.h"
#include "core/base/Units.h"
#include "core/identify/TrialShip.h"
#include "core/seakeeping/SeaHulls.h"

namespace sagara::tools {
namespace {

std::string motionsOf(const core::Trial& trial) {
    Table table({"time_s", "heave_m", "roll_deg", "pitch_deg", "heading_deg", "surge_mps", "sway_mps"});
    for (const core::TrialSample& s : trial.samples) {
        table.add({s.time_s, s.heave_m, s.roll_rad / core::kDegree_rad, s.pitch_rad / core::kDegree_rad,
                   s.heading_rad / core::kDegree_rad, s.surge_mps, s.sway_mps});
    }
    return table.text();
}

}  // namespace

int runDecayTool(const run::Store& store, const DecayOptions& o) {
    const auto vessel = openVessel(store, o.ship);
    if (!vessel) return run::tell(vessel.error()), run::kBadRequest;
    core::TrialShip ship(*vessel, o.ship.model, o.ship.depth_m);
    // Published roll of a model's own was published without a hull's tables.
    if (o.dof != core::Decay::Dof::Roll || !ship.dynamics().ownsRoll())
        ship = core::TrialShip(*vessel, o.ship.model, o.ship.depth_m, store.hulls()->of(vessel->hull));
    core::TrialOptions options;
    options.approach = ship.holding(o.speed_mps);
    options.duration_s = o.duration_s;
    takeRows(options, o.dt_s);
    const double unit = o.dof == core::Decay::Dof::Heave ? 1.0 : core::kDegree_rad;
    const core::Trial trial = core::runDecay(ship, {.dof = o.dof, .start = unit * o.start}, options);
    return writeTrial(*vessel, trial, motionsOf(trial), o.measures, o.csv);
}

}  // namespace sagara::tools
