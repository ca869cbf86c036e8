#include "core/bridge/ThrusterControl.h"

#include <algorithm>

namespace sagara::core {

void runThruster(const Thruster& thruster, ThrusterState& state, double dt_s) {
    const double most = dt_s / thruster.rampTime_s;
    const double order = state.failed ? 0.0 : state.order;
    state.share += std::clamp(order - state.share, -most, most);
}

}  // namespace sagara::core
