#include "TestShip.h"

#include <stdexcept>

#include "tests/support/Assets.h"

namespace sagara::core::test {

Vessel shippedVessel(const std::string& id) {
    auto vessel = loadVessel(id, sagara::test::readAsset("vessels/" + id + ".json"));
    if (!vessel) throw std::runtime_error(vessel.error().text());
    return std::move(vessel).value();
}

TestShip::TestShip(const std::string& vesselId)
    : vessel(shippedVessel(vesselId)),
      dynamics(vessel),
      hull(contactHull(vessel.hull, dynamics.lateralMass_kg())),
      keel(keelOf(vessel.hull, dynamics.heaveStiffness_Npm())) {}

NorthEast TestShip::overGround_mps() const {
    return frame().vector({motion.surge_mps, motion.sway_mps}) + current;
}

}  // namespace sagara::core::test
