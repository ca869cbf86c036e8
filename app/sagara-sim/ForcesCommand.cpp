#include "Between.h"
#include "Commands.h"
#include "VesselOptions.h"
#include "app/tools/Forces.h"
#include "core/motion/Actuators.h"

namespace sagara::sim {

void addForces(Commands& commands) {
    auto o = std::make_shared<tools::ForcesOptions>();
    CLI::App* forces =
        commands.add("forces", "forces on a vessel in a state of motion, and her accelerations",
                     [o](run::Store& store) { return tools::runForces(store, *o); });
    addVesselOptions(*forces, o->ship)->required();
    forces->add_option("--state", o->state, "u,v,r,phi,p in m/s, m/s, rad/s, rad, rad/s; at least u")
        ->required()
        ->delimiter(',')
        ->expected(1, 5)
        ->check(between(-60.0, 60.0));
    forces->add_option("--rudder-deg", o->rudder_deg, "positive to starboard (0)")
        ->check(between(-90.0, 90.0));
    forces->add_option("--rps", o->shaft_rps, "of the shafts, or of each: n1,n2 (0)")
        ->delimiter(',')
        ->expected(1, int{core::kMostShafts})
        ->check(between(-100.0, 100.0));
    addCsvOption(*forces, o->csv);
}

}  // namespace sagara::sim
