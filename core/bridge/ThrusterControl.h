#pragma once

#include "core/vessel/Thrusters.h"

namespace sagara::core {

/// One thruster and its lever. Shares of full thrust, starboard (the ship's end moves to starboard) positive.
struct ThrusterState {
    double order = 0.0;
    double share = 0.0;
    bool failed = false;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.order, self.share, self.failed);
    }
};

/// Runs it for one tick towards its order, stop to full in its ramp time. A failed one runs down as fast and
/// stays stopped.
void runThruster(const Thruster& thruster, ThrusterState& state, double dt_s);

}  // namespace sagara::core
