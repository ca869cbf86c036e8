#include <gtest/gtest.h>

#include <cmath>

#include "FreeBody.h"
#include "SmallAreas.h"
#include "TestShip.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

using test::FreeBody;
using test::TestShip;

const double kEast = kPi / 2;
constexpr double kThick_m = 0.9, kStiffness_Npm = 250e3;

/// A ship alongside the fendered quay, head east, moved by a load of its own and what she touches.
struct Alongside {
    Alongside(const std::string& vessel, double fenderSpacing_m)
        : area(test::fenderedQuay(fenderSpacing_m, kStiffness_Npm)), ship(vessel) {
        ship.motion.heading_rad = kEast;
        ship.motion.north_m = kThick_m + 0.5 * ship.vessel.hull.beam_m;
    }
    Area area;
    TestShip ship;

    double gap_m() const { return ship.motion.north_m - 0.5 * ship.vessel.hull.beam_m; }
    Load contactNow() const {
        Obstacles found;
        findObstacles(area, ship.hull, ship.motion, found);
        return contactLoad(found, ship.hull, ship.motion, ship.current);
    }
    void tick(const Load& load) {
        Obstacles found;
        findObstacles(area, ship.hull, ship.motion, found);
        ship.tick([&](const ShipMotion& m) { return load + contactLoad(found, ship.hull, m, ship.current); });
    }
};

TEST(Fender, PushesWithItsStiffnessTimesItsCompressionAlongTheOutwardNormal) {
    Area area = test::fenderedQuay(1000.0, kStiffness_Npm);  // one, at 100 m west
    FreeBody body(54.0, 8.6, 750e3);
    body.motion = {.north_m = 4.3 + 0.7, .east_m = -95.0, .heading_rad = kEast};
    Obstacles found;
    findObstacles(area, body.hull, body.motion, found);
    EXPECT_EQ(found.fenders.count, 1u);
    const Load load = contactLoad(found, body.hull, body.motion, {});
    EXPECT_NEAR(load.sway_N, -kStiffness_Npm * 0.2, 1e-6);  // to port: north
    EXPECT_NEAR(load.surge_N, 0.0, 1e-6);
    EXPECT_NEAR(load.yaw_Nm, load.sway_N * -5.0, 1e-3);
}

TEST(Fender, ReachesOnlyAsFarAsItIsThick) {
    const Area area = test::fenderedQuay(10.0, kStiffness_Npm);
    FreeBody body(54.0, 8.6, 750e3);
    body.motion = {.north_m = 4.3 + kThick_m + 1e-6, .heading_rad = kEast};
    Obstacles found;
    findObstacles(area, body.hull, body.motion, found);
    EXPECT_EQ(contactLoad(found, body.hull, body.motion, {}).sway_N, 0.0);
}

TEST(Fender, StopsABlowWithoutGivingEnergyBack) {
    const Area area = test::fenderedQuay(10.0, kStiffness_Npm);
    for (const double angle_deg : {0.0, 3.0, -5.0, 180.0}) {
        FreeBody body(54.0, 8.6, 750e3);
        body.motion = {.north_m = 4.3 + 3.5, .heading_rad = kEast + angle_deg * kDegree_rad};
        body.setVelocity({-0.2, 0.05});
        const double before_J = body.energy_J();
        double least_J = before_J;
        for (int i = 0; i < 30 * kTicksPerSecond; ++i) {
            body.tick(area);
            ASSERT_LE(body.energy_J(), before_J * (1.0 + 1e-9)) << angle_deg;
            least_J = std::min(least_J, body.energy_J());
        }
        EXPECT_LT(least_J, 0.7 * before_J) << angle_deg;  // it was a blow
        EXPECT_LT(body.energy_J(), 0.95 * before_J) << angle_deg;
    }
}

class ShipOnFenders : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Shipped, ShipOnFenders, ::testing::Values("patrol51", "esso-osaka"),
                         [](const auto& row) { return std::string(row.param).substr(0, 4); });

TEST_P(ShipOnFenders, ComesToRestWhereTheFendersCarryThePush) {
    Alongside a(GetParam(), 5.0);
    const double push_N =
        0.1 * kStiffness_Npm * 0.1 * a.ship.vessel.hull.lengthOverall_m;  // some 0.1 m of compression
    for (int i = 0; i < 120 * kTicksPerSecond; ++i) a.tick({.sway_N = push_N});
    EXPECT_NEAR(a.contactNow().sway_N, -push_N, 0.02 * push_N);
    EXPECT_NEAR(a.contactNow().yaw_Nm, 0.0, 0.02 * push_N * a.ship.vessel.hull.lengthBp_m);
    EXPECT_LT(length(a.ship.overGround_mps()), 0.003);
    // Springs along what lies flat, compression d + e x: sum k (d + e x) = F, sum k (d + e x) x = 0.
    const double length_m = a.ship.vessel.hull.lengthOverall_m, beam_m = a.ship.vessel.hull.beam_m;
    double n = 0.0, sx = 0.0, sxx = 0.0;
    for (const Fender& fender : a.area.berths[0].fenders) {
        const double x_m = fender.position.east_m;
        if (x_m < -0.5 * length_m + 0.5 * beam_m || x_m > 0.2 * length_m) continue;
        n += 1.0, sx += x_m, sxx += x_m * x_m;
    }
    const double compression_m = push_N / kStiffness_Npm * sxx / (n * sxx - sx * sx);
    // a fender just beyond either end of the flat side takes a little
    EXPECT_NEAR(kThick_m - a.gap_m(), compression_m, 0.1 * compression_m);
    EXPECT_NEAR(a.ship.motion.heading_rad, kEast, 0.5 * kDegree_rad);
}

TEST_P(ShipOnFenders, AShipThatDriftsOnLosesHerSpeed) {
    Alongside a(GetParam(), 5.0);
    a.ship.motion.north_m += 0.5;
    a.ship.motion.sway_mps = 0.1;
    double fastest_mps = 0.0;
    for (int i = 0; i < 60 * kTicksPerSecond; ++i) {
        a.tick({});
        if (i > 20 * kTicksPerSecond) fastest_mps = std::max(fastest_mps, std::abs(a.ship.motion.sway_mps));
    }
    EXPECT_GT(a.gap_m(), 0.0);  // the fenders are enough: she never comes to the wall
    EXPECT_LT(fastest_mps, 0.1);
}

TEST(Fenders, MoreThanCanBeHeldDoNoHarm) {
    const Area area = test::fenderedQuay(0.25, kStiffness_Npm);  // 801, of which 64 are held
    FreeBody body(54.0, 8.6, 750e3);
    body.motion = {.north_m = 4.3 + 1.2, .heading_rad = kEast + 0.02};
    body.setVelocity({-0.2, 0.0});
    const double before_J = body.energy_J();
    Obstacles found;
    findObstacles(area, body.hull, body.motion, found);
    EXPECT_EQ(found.fenders.count, 64u);
    for (int i = 0; i < 30 * kTicksPerSecond; ++i) {
        body.tick(area);
        ASSERT_LE(body.energy_J(), before_J * (1.0 + 1e-9));
    }
    EXPECT_GT(body.motion.north_m, 4.3);
}

TEST(Shoreline, MorePiecesThanCanBeHeldDoNoHarm) {
    std::vector<NorthEast> ring{{-500.0, 3000.0}, {-500.0, -3000.0}};
    for (double east_m = -3000.0; east_m <= 3000.0; east_m += east_m > -60.0 && east_m < 60.0 ? 0.1 : 20.0) {
        ring.push_back({0.0, east_m});
    }
    const Area area = test::withLand({ring});
    FreeBody body(54.0, 8.6, 750e3);
    body.motion = {.north_m = 4.3 + 0.2, .heading_rad = kEast};
    body.setVelocity({-0.5, 0.0});
    const double before_J = body.energy_J();
    for (int i = 0; i < 10 * kTicksPerSecond; ++i) {
        body.tick(area);
        ASSERT_TRUE(std::isfinite(body.energy_J()));
        ASSERT_LE(body.energy_J(), before_J * (1.0 + 1e-9));
    }
    EXPECT_LT(body.southOf_m(0.0), 1.0);
}

TEST(ContactKindNames, AreThoseOfTheEvents) {
    EXPECT_STREQ(contactKindName(ContactKind::Fender), "fender");
    EXPECT_STREQ(contactKindName(ContactKind::Quay), "quay");
    EXPECT_STREQ(contactKindName(ContactKind::Breakwater), "breakwater");
    EXPECT_STREQ(contactKindName(ContactKind::Shore), "shore");
    EXPECT_STREQ(contactKindName(ContactKind::Ship), "ship");
}

}  // namespace
}  // namespace sagara::core
