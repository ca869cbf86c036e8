#include <gtest/gtest.h>

#include <cmath>

#include "TestShip.h"
#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "core/motion/WindLoad.h"
#include "core/world/Anchor.h"
#include "core/world/Catenary.h"

namespace sagara::core {
namespace {

/// A ship that lies to her port anchor, dug in at the origin, wind from the north.
struct Anchored {
    Anchored(const std::string& vessel, double depth_m, double cable_m) : ship(vessel), ground{depth_m, 1.0} {
        anchor.status = AnchorStatus::Held;
        anchor.onBottom = true;
        anchor.set = 1.0;
        anchor.cableOut_m = cable_m;
    }
    test::TestShip ship;
    AnchorGround ground;
    AnchorState anchor;
    WindVelocity wind;

    const AnchorGear& gear() const { return ship.vessel.groundTackle.anchors[0]; }
    Load windLoadNow() const {
        const BodyPoint ground_mps = ship.frame().vectorInBody(ship.overGround_mps());
        return windLoad(ship.vessel.windage, ship.vessel.hull.lengthOverall_m, wind, ship.motion.heading_rad,
                        ground_mps);
    }
    void tick() {
        const Load load = windLoadNow() + anchorLoad(gear(), anchor, ship.motion);
        ship.tick([&](const ShipMotion&) { return load; });
        workAnchor(gear(), anchor, ground, ship.motion, kTick_s);
    }
};

TEST(AnchoredShip, ComesToRestInASteadyWindWhereTheCableBalancesIt) {
    Anchored a("esso-osaka", 30.0, 250.0);
    a.wind = {15.0, 0.0};
    a.ship.motion.north_m = -397.0;
    a.ship.motion.heading_rad = 5.0 * kDegree_rad;
    const int hour = 3600 * kTicksPerSecond, measured = 2 * hour;
    for (int i = 0; i < hour; ++i) a.tick();
    double pull_N = 0.0, wind_N = 0.0, fastest_mps = 0.0;
    for (int i = 0; i < measured; ++i) {  // a dozen of her swings on the cable, which is a soft spring
        a.tick();
        const HeadingFrame frame = a.ship.frame();
        const Load pull = anchorLoad(a.gear(), a.anchor, a.ship.motion), wind = a.windLoadNow();
        pull_N += frame.vector({pull.surge_N, pull.sway_N}).north_m / measured;
        wind_N += frame.vector({wind.surge_N, wind.sway_N}).north_m / measured;
        fastest_mps = std::max(fastest_mps, length(a.ship.overGround_mps()));
    }
    EXPECT_LT(fastest_mps, 0.05);                 // a tenth of a knot: the water hardly damps the swing
    EXPECT_NEAR(pull_N, -wind_N, 0.03 * pull_N);  // part of a swing is left over in the mean
    EXPECT_NEAR(a.ship.motion.heading_rad, 0.0, 5.0 * kDegree_rad);
    EXPECT_EQ(a.anchor.dragged_m, 0.0);
}

TEST(AnchoredShip, AtTheCatenarysDistanceSheStays) {
    Anchored a("esso-osaka", 30.0, 250.0);
    a.wind = {15.0, 0.0};
    const double wind_N = -a.windLoadNow().surge_N;
    const double weight_Npm = (1.0 - 1025.0 / 7850.0) * a.gear().cableMass_kgpm * kGravity_mps2;
    // plain catenary, stretch of 0.1 m left out
    const double height_m = 30.0 + a.gear().hawseHeight_m, scale_m = wind_N / weight_Npm;
    const double hangs_m = std::sqrt(height_m * (height_m + 2.0 * scale_m));
    const double apart_m = 250.0 - hangs_m + scale_m * std::asinh(hangs_m / scale_m);
    a.ship.motion.north_m = -apart_m - a.gear().hawse.x_m;
    for (int i = 0; i < 600 * kTicksPerSecond; ++i) a.tick();
    // the hawse is 9 m to port: she lies a little across the wind, which then pushes harder
    EXPECT_NEAR(a.ship.motion.north_m, -apart_m - a.gear().hawse.x_m, 1.0);
    EXPECT_NEAR(a.anchor.pull_N, wind_N, 0.2 * wind_N);  // 28 kN/m: what that metre makes
}

TEST(AnchoredShip, ALightShipShearsAboutAndKeepsWithinHerCable) {
    Anchored a("patrol51", 18.0, 100.0);
    a.wind = {10.0, 0.0};
    a.ship.motion.north_m = -110.0;
    a.ship.motion.heading_rad = 20.0 * kDegree_rad;
    double widest_rad = 0.0, farthest_m = 0.0;
    for (int i = 0; i < 3600 * kTicksPerSecond; ++i) {
        a.tick();
        const NorthEast hawse = a.ship.frame().point(a.gear().hawse);
        widest_rad = std::max(widest_rad, std::abs(a.ship.motion.heading_rad));
        farthest_m = std::max(farthest_m, distance(hawse, a.anchor.position));
    }
    EXPECT_LT(widest_rad, 75.0 * kDegree_rad);  // never broadside
    EXPECT_LT(farthest_m, std::sqrt(100.0 * 100.0 - 21.5 * 21.5) + 0.1);
    EXPECT_EQ(a.anchor.dragged_m, 0.0);
}

}  // namespace
}  // namespace sagara::core
