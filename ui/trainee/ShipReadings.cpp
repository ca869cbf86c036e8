#include "ui/trainee/ShipReadings.h"

#include <cmath>

#include "core/base/Angle.h"

namespace sagara::ui::console {

ShipReadings readingsOf(const core::World& world, const core::Snapshot& now, std::size_t ship,
                        const core::EchoSounder& sounder) {
    constexpr double kLeastWay_mps = 0.1;
    const core::OwnShipView& own = now.ships[ship];
    const core::ShipMotion& m = own.motion;
    ShipReadings r;
    r.convergence_rad = -world.area.frame.convergence_rad(m.position());
    r.heading_rad = core::wrapTwoPi(m.heading_rad + r.convergence_rad);
    r.turn_radps = m.yawRate_radps;
    r.overGround_mps = core::length(own.overGround_mps);
    if (r.overGround_mps > kLeastWay_mps)
        r.course_rad = core::wrapTwoPi(core::bearing_rad({}, own.overGround_mps) + r.convergence_rad);
    r.ahead_mps = m.surge_mps;
    r.toStarboard_mps = m.sway_mps;
    r.wind_mps = now.wind.speed_mps;
    r.windFrom_rad = core::wrapTwoPi(now.wind.windFrom_rad + r.convergence_rad);
    // Air past the ship: the wind less her way over the ground.
    const core::NorthEast air = -now.wind.speed_mps * core::unitVector(now.wind.windFrom_rad);
    const core::NorthEast past = air - own.overGround_mps;
    r.relative_mps = core::length(past);
    r.relativeFrom_rad = core::wrapPi(core::bearing_rad(past, {}) - m.heading_rad);
    r.underKeel_m = core::soundedDepth_m(world.area, sounder, m, now.tide_m);
    return r;
}

}  // namespace sagara::ui::console
