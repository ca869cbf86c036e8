#pragma once

#include <string>

#include "core/base/SimTime.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/ShipDynamics.h"
#include "core/vessel/Vessel.h"
#include "core/world/Contact.h"
#include "core/world/UnderKeel.h"

namespace sagara::core::test {

/// A vessel of assets/vessels.
Vessel shippedVessel(const std::string& id);

/// A shipped vessel in still water, moved tick by tick as an exercise moves her.
struct TestShip {
    explicit TestShip(const std::string& vesselId);

    Vessel vessel;
    ShipDynamics dynamics;
    ContactHull hull;
    Keel keel;
    ShipMotion motion;
    Actuators actuators;
    NorthEast current;

    HeadingFrame frame() const { return {motion.position(), motion.heading_rad}; }
    NorthEast overGround_mps() const;

    /// `load`: of the motion, worked out in every stage of the step.
    template <typename LoadAt>
    void tick(LoadAt&& load, double dt_s = kTick_s) {
        motion = rk4Step(motion, dt_s, [&](const ShipMotion& m) {
            return dynamics.derivative(m, actuators, load(m), current);
        });
    }
};

}  // namespace sagara::core::test
