#include "app/tools/Forces.h"

#include "app/run/Console.h"
#include "app/run/RunOptions.h"
#include "app/tools/Table.h"
#include "core/base/Units.h"
#include "core/identify/TrialShip.h"

namespace sagara::tools {
namespace {

core::ShipMotion motionOf(std::vector<double> state) {
    state.resize(5);
    core::ShipMotion m;
    m.surge_mps = state[0];
    m.sway_mps = state[1];
    m.yawRate_radps = state[2];
    m.roll_rad = state[3];
    m.rollRate_radps = state[4];
    return m;
}

core::Actuators actuatorsOf(const ForcesOptions& o) {
    core::Actuators actuators;
    actuators.rudder_rad = o.rudder_deg * core::kDegree_rad;
    if (o.shaft_rps.size() == 1) actuators.shaft_rps.fill(o.shaft_rps.front());
    if (o.shaft_rps.size() > 1)
        std::copy(o.shaft_rps.begin(), o.shaft_rps.end(), actuators.shaft_rps.begin());
    return actuators;
}

}  // namespace

int runForces(const run::Store& store, const ForcesOptions& o) {
    const auto vessel = openVessel(store, o.ship);
    if (!vessel) return run::tell(vessel.error()), run::kBadRequest;
    const core::ShipMotion m = motionOf(o.state);
    const core::Actuators a = actuatorsOf(o);
    const core::TrialShip ship(*vessel, o.ship.model, o.ship.depth_m);
    const core::HullForces f = ship.dynamics().hullForces(m, a, o.ship.depth_m);
    const core::ShipMotion rate = ship.dynamics().derivative(m, a, {}, {}, o.ship.depth_m);
    Table table({"u_mps",
                 "v_mps",
                 "r_radps",
                 "phi_rad",
                 "p_radps",
                 "rudder_deg",
                 "shaft_rps",
                 "hull_surge_N",
                 "hull_sway_N",
                 "hull_yaw_Nm",
                 "propeller_surge_N",
                 "propeller_sway_N",
                 "propeller_yaw_Nm",
                 "rudder_surge_N",
                 "rudder_sway_N",
                 "rudder_yaw_Nm",
                 "u_dot_mps2",
                 "v_dot_mps2",
                 "p_dot_radps2",
                 "r_dot_radps2"});
    table.add({m.surge_mps,        m.sway_mps,       m.yawRate_radps,     m.roll_rad,
               m.rollRate_radps,   o.rudder_deg,     a.shaft_rps[0],      f.hull.surge_N,
               f.hull.sway_N,      f.hull.yaw_Nm,    f.propeller.surge_N, f.propeller.sway_N,
               f.propeller.yaw_Nm, f.rudder.surge_N, f.rudder.sway_N,     f.rudder.yaw_Nm,
               rate.surge_mps,     rate.sway_mps,    rate.rollRate_radps, rate.yawRate_radps});
    return writeResult(o.csv, table.text());
}

}  // namespace sagara::tools
