#include <gtest/gtest.h>

#include <cmath>

#include "SmallAreas.h"
#include "TestShip.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

using test::TestShip;

struct Arrival {
    const char* vessel;
    double angle_deg;  ///< heading off the run of the quay
    double speed_mps;  ///< onto it
};
class ShipOnQuay : public ::testing::TestWithParam<Arrival> {};

double speed_mps(const TestShip& ship) { return length(ship.overGround_mps()); }

TEST_P(ShipOnQuay, IsStoppedAndGainsNoSpeed) {
    const Area quay = test::longQuay();
    TestShip ship(GetParam().vessel);
    const double angle_rad = GetParam().angle_deg * kDegree_rad;
    ship.motion.heading_rad = kPi / 2 + angle_rad;
    ship.motion.north_m = 0.1 + 0.5 * (ship.vessel.hull.lengthOverall_m * std::abs(std::sin(angle_rad)) +
                                       ship.vessel.hull.beam_m * std::abs(std::cos(angle_rad)));
    const BodyPoint v = ship.frame().vectorInBody({-GetParam().speed_mps, 0.0});
    ship.motion.surge_mps = v.x_m;
    ship.motion.sway_mps = v.y_m;
    double deepest_m = 0.0;
    for (int i = 0; i < 60 * kTicksPerSecond; ++i) {
        Obstacles found;
        findObstacles(quay, ship.hull, ship.motion, found);
        ship.tick([&](const ShipMotion& m) { return contactLoad(found, ship.hull, m, {}); });
        for (const BodyPoint& p : ship.hull.outline)
            deepest_m = std::max(deepest_m, -ship.frame().point(p).north_m);
        ASSERT_LT(speed_mps(ship), 1.05 * GetParam().speed_mps)
            << i;  // of midship, while she swings round the point of contact
        ASSERT_LT(std::abs(ship.motion.yawRate_radps) * ship.vessel.hull.lengthBp_m,
                  6.0 * GetParam().speed_mps)
            << i;
    }
    EXPECT_GT(deepest_m, 0.0);
    EXPECT_LT(deepest_m, GetParam().speed_mps / 6.0);
    EXPECT_LT(speed_mps(ship), 0.8 * GetParam().speed_mps);
    EXPECT_LT(std::abs(ship.motion.roll_rad), 10.0 * kDegree_rad);
}

INSTANTIATE_TEST_SUITE_P(Shipped, ShipOnQuay,
                         ::testing::Values(Arrival{"patrol51", 0.0, 0.5}, Arrival{"patrol51", 4.0, 0.5},
                                           Arrival{"patrol51", 90.0, 2.0}, Arrival{"patrol51", -60.0, 1.0},
                                           Arrival{"esso-osaka", 0.0, 0.2}, Arrival{"esso-osaka", -1.0, 0.2},
                                           Arrival{"esso-osaka", 90.0, 1.0}));

}  // namespace
}  // namespace sagara::core
