#pragma once

#include "core/vessel/Machinery.h"

namespace sagara::core {

/// The steering gear between the wheel and the rudders. Two pumps; each moves the rudder at half the full
/// rate.
struct SteeringGearState {
    double order_rad = 0.0;
    double angle_rad = 0.0;  ///< achieved; positive turns the bow to starboard
    std::uint8_t pumpsFailed = 0;
    bool jammed = false;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.order_rad, self.angle_rad, self.pumpsFailed, self.jammed);
    }
};

/// Runs the gear for one tick; returns the mean angle in it, which is what the hull feels.
double runSteeringGear(const Steering& steering, SteeringGearState& gear, double dt_s);

}  // namespace sagara::core
