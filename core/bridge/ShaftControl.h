#pragma once

#include "core/vessel/Machinery.h"

namespace sagara::core {

/// One engine and its shaft, as the telegraph sees them.
struct ShaftState {
    double order_rps = 0.0;
    double speed_rps = 0.0;
    double standing_s = 0.0;     ///< time the shaft still has to stand before it may turn the other way
    std::int8_t lastTurned = 0;  ///< +1 ahead, -1 astern, 0 not yet
    bool failed = false;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.order_rps, self.speed_rps, self.standing_s, self.lastTurned, self.failed);
    }
};

/// Runs the shaft for one tick towards its order: rate limit, a stand between ahead and astern (one that it
/// has stood already counts). A failed engine lets it run down at a third of the rate.
void runShaft(const PropulsionUnit& unit, ShaftState& shaft, double dt_s);

}  // namespace sagara::core
