#include "core/world/MooringLine.h"

#include <gtest/gtest.h>

#include <cmath>

#include "TestShip.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

const MooringGear kGear = test::shippedVessel("patrol51").mooring;

/// A line of 20 m on the bow of a ship that heads north at the origin, to a bollard ahead.
class MooringLine : public ::testing::Test {
protected:
    const LineLayout layout{{10.0, -3.0}, {30.0, -3.0}};
    LineState line{LineStatus::Fast, 20.0, 0.0};
    ShipMotion ship;

    double distance_m() const { return distance(ship.position() + NorthEast{10.0, -3.0}, layout.bollard); }
    bool tick() { return workLine(kGear, layout, line, ship, kTick_s); }
    double work_s(double seconds) {
        int ticks = 0;
        for (; ticks < static_cast<int>(seconds / kTick_s); ++ticks) tick();
        return ticks * kTick_s;
    }
};

TEST_F(MooringLine, TensionIsStiffnessTimesStrain) {
    EXPECT_EQ(lineTension_N(kGear, line, 19.0, 0.0), 0.0);
    EXPECT_EQ(lineTension_N(kGear, line, 20.0, 0.0), 0.0);
    EXPECT_NEAR(lineTension_N(kGear, line, 20.2, 0.0), 0.01 * kGear.stiffness_N, 1e-6);
    line.length_m = 40.0;
    EXPECT_NEAR(lineTension_N(kGear, line, 40.2, 0.0), 0.005 * kGear.stiffness_N, 1e-6);
}

TEST_F(MooringLine, AGrowingStretchPullsHarderAndAShrinkingOneLess) {
    const double still_N = lineTension_N(kGear, line, 20.2, 0.0);
    EXPECT_GT(lineTension_N(kGear, line, 20.2, 0.1), still_N);
    EXPECT_LT(lineTension_N(kGear, line, 20.2, -0.1), still_N);
    EXPECT_EQ(lineTension_N(kGear, line, 20.2, -10.0), 0.0);  // a line cannot push
    EXPECT_EQ(lineTension_N(kGear, line, 19.9, 10.0), 0.0);   // nor pull while it is slack
}

TEST_F(MooringLine, OnlyALineOnItsBollardPulls) {
    for (const LineStatus status : {LineStatus::In, LineStatus::CastOff, LineStatus::Parted}) {
        line.status = status;
        EXPECT_EQ(lineTension_N(kGear, line, 25.0, 0.0), 0.0);
        ship.north_m = -5.0;
        EXPECT_EQ(lineLoad(kGear, layout, line, ship, {}).surge_N, 0.0);
    }
}

TEST_F(MooringLine, PullsTheFairleadTowardsTheBollard) {
    ship = {.north_m = 15.0, .east_m = -5.0, .heading_rad = kPi / 2};  // fairlead at north 18, east 5
    const Load load = lineLoad(kGear, {layout.fairlead, {18.0, 26.0}}, line, ship, {});
    const double tension_N = kGear.stiffness_N * 1.0 / 20.0;
    EXPECT_NEAR(load.surge_N, tension_N, 1e-6);  // the bollard is due east: ahead
    EXPECT_NEAR(load.sway_N, 0.0, 1e-6);
    EXPECT_NEAR(load.yaw_Nm, 3.0 * tension_N, 1e-5);  // 3 m to port of the middle: turns her to starboard
    EXPECT_EQ(load.heave_N, 0.0);
}

TEST_F(MooringLine, DampingWorksOnTheMotionOverTheGround) {
    ship.north_m = -0.2;
    const double still_N = lineLoad(kGear, layout, line, ship, {}).surge_N;
    ship.surge_mps = 0.3;  // through the water, stemming a current: at rest
    EXPECT_NEAR(lineLoad(kGear, layout, line, ship, {-0.3, 0.0}).surge_N, still_N, 1e-6);
    EXPECT_LT(lineLoad(kGear, layout, line, ship, {}).surge_N, still_N);  // towards the bollard
    EXPECT_GT(lineLoad(kGear, layout, line, ship, {-0.5, 0.0}).surge_N, still_N);
}

TEST_F(MooringLine, TheMirroredLineMakesTheMirroredLoad) {
    ship = {.east_m = 0.4, .heading_rad = 0.1, .surge_mps = 0.2, .sway_mps = -0.1, .yawRate_radps = 0.01};
    const ShipMotion other{
        .east_m = -0.4, .heading_rad = -0.1, .surge_mps = 0.2, .sway_mps = 0.1, .yawRate_radps = -0.01};
    const Load port = lineLoad(kGear, {{10.0, -3.0}, {30.0, -9.0}}, line, ship, {0.1, 0.2});
    const Load starboard = lineLoad(kGear, {{10.0, 3.0}, {30.0, 9.0}}, line, other, {0.1, -0.2});
    ASSERT_GT(port.surge_N, 0.0);
    EXPECT_NEAR(port.surge_N, starboard.surge_N, 1e-6);
    EXPECT_NEAR(port.sway_N, -starboard.sway_N, 1e-6);
    EXPECT_NEAR(port.yaw_Nm, -starboard.yaw_Nm, 1e-6);
}

TEST_F(MooringLine, PartsAtItsBreakingLoad) {
    // stretch at break: 220 kN over 1300 kN
    ship.north_m = -20.0 * kGear.breakingLoad_N / kGear.stiffness_N + 1e-6;
    EXPECT_FALSE(tick());
    EXPECT_NEAR(line.tension_N, kGear.breakingLoad_N, 0.1);
    ship.north_m -= 2e-6;
    EXPECT_TRUE(tick());
    EXPECT_EQ(line.status, LineStatus::Parted);
    EXPECT_EQ(line.tension_N, 0.0);
    EXPECT_FALSE(tick());  // only once
    EXPECT_EQ(line.status, LineStatus::Parted);
}

TEST_F(MooringLine, FastItKeepsItsLength) {
    ship.north_m = -0.5;
    work_s(60.0);
    EXPECT_EQ(line.length_m, 20.0);
    EXPECT_NEAR(line.tension_N, kGear.stiffness_N * 0.5 / 20.0, 1e-6);
}

TEST_F(MooringLine, SlackedItIsPaidOutAtTheWinchSpeed) {
    ship.north_m = -0.5;
    line.status = LineStatus::Slacking;
    const double time_s = work_s(5.0);
    EXPECT_NEAR(line.length_m, 20.0 + kGear.winchSpeed_mps * time_s, 1e-9);
    EXPECT_EQ(line.tension_N, 0.0);
}

TEST_F(MooringLine, HeavingStopsAtThePullOfTheWinch) {
    line.status = LineStatus::Heaving;
    const double time_s = work_s(0.5);
    EXPECT_NEAR(line.length_m, 20.0 - kGear.winchSpeed_mps * time_s, 1e-9);
    work_s(60.0);  // the ship does not come
    const double oneStep_N = kGear.stiffness_N * kGear.winchSpeed_mps * kTick_s / 19.0;
    EXPECT_GE(line.tension_N, kGear.winchPull_N);
    EXPECT_LE(line.tension_N, kGear.winchPull_N + 1.1 * oneStep_N);
    const double stalled_m = line.length_m;
    ship.north_m += 1.0;  // she gives way, and the winch takes it in
    work_s(60.0);
    EXPECT_NEAR(line.length_m, stalled_m - 1.0, 0.05);  // strain is per length
}

TEST_F(MooringLine, IsNotHoveShorterThanTwoMetres) {
    ship.north_m = 19.9;
    line.status = LineStatus::Heaving;
    work_s(120.0);
    EXPECT_EQ(line.length_m, 2.0);
}

TEST_F(MooringLine, LetGoItIsHauledInAndThenAboard) {
    line.status = LineStatus::CastOff;
    ship.north_m = -5.0;
    EXPECT_EQ(lineLoad(kGear, layout, line, ship, {}).surge_N, 0.0);
    double time_s = 0.0;
    while (line.status == LineStatus::CastOff) {
        tick();
        time_s += kTick_s;
        ASSERT_LT(time_s, 100.0);
    }
    EXPECT_EQ(line.status, LineStatus::In);
    EXPECT_EQ(line.length_m, 0.0);
    EXPECT_NEAR(time_s, 20.0 / (3.0 * kGear.winchSpeed_mps),
                2 * kTick_s);  // free, it comes three times as fast
}

TEST_F(MooringLine, MadeFastItHasATouchOfTension) {
    const LineState fast = madeFast(layout, ship);
    EXPECT_EQ(fast.status, LineStatus::Fast);
    EXPECT_NEAR(lineTension_N(kGear, fast, distance_m(), 0.0), 0.002 * kGear.stiffness_N,
                0.003 * 0.002 * kGear.stiffness_N);  // strain of 1/0.998
}

TEST(LineStatusNames, AreThoseOfTheDocuments) {
    EXPECT_STREQ(lineStatusName(LineStatus::In), "in");
    EXPECT_STREQ(lineStatusName(LineStatus::Fast), "fast");
    EXPECT_STREQ(lineStatusName(LineStatus::Slacking), "slacking");
    EXPECT_STREQ(lineStatusName(LineStatus::Heaving), "heaving");
    EXPECT_STREQ(lineStatusName(LineStatus::CastOff), "castOff");
    EXPECT_STREQ(lineStatusName(LineStatus::Parted), "parted");
}

/// Two springs on the centreline, the one leading aft from forward, the other forward from aft.
struct Sprung {
    explicit Sprung(const std::string& vessel) : ship(vessel) {
        const double quarter_m = 0.25 * ship.vessel.hull.lengthBp_m;
        layouts = {{{quarter_m, 0.0}, {-quarter_m, 0.0}}, {{-quarter_m, 0.0}, {quarter_m, 0.0}}};
        for (const LineLayout& layout : layouts) lines.push_back(madeFast(layout, ship.motion));
    }
    test::TestShip ship;
    std::vector<LineLayout> layouts;
    std::vector<LineState> lines;

    void tick(double push_N) {
        ship.tick([&](const ShipMotion& m) {
            Load load{.surge_N = push_N};
            for (std::size_t i = 0; i < lines.size(); ++i) {
                load = load + lineLoad(ship.vessel.mooring, layouts[i], lines[i], m, ship.current);
            }
            return load;
        });
        for (std::size_t i = 0; i < lines.size(); ++i) {
            workLine(ship.vessel.mooring, layouts[i], lines[i], ship.motion, kTick_s);
        }
    }
};

class MooredShip : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Shipped, MooredShip, ::testing::Values("patrol51", "esso-osaka"),
                         [](const auto& row) { return std::string(row.param).substr(0, 4); });

TEST_P(MooredShip, TwoSpringsHoldHerAgainstASteadyPush) {
    for (const double side : {1.0, -1.0}) {
        Sprung s(GetParam());
        const double push_N = side * 0.4 * s.ship.vessel.mooring.breakingLoad_N;
        const std::size_t holds = side > 0.0 ? 0 : 1;
        const double stretch_m = std::abs(push_N) * s.lines[0].length_m / s.ship.vessel.mooring.stiffness_N;
        const double rest_m =
            side * (stretch_m - 0.002 / 0.998 * s.lines[0].length_m);  // made fast with 0.2 % in them
        s.ship.motion.north_m =
            0.9 * rest_m;  // she swings about it for long: lines of this size hardly damp her
        const int ticks = 1800 * kTicksPerSecond;
        double tension_N = 0.0, north_m = 0.0, most_N = 0.0;
        for (int i = 0; i < ticks; ++i) {
            s.tick(push_N);
            tension_N += s.lines[holds].tension_N / ticks;
            north_m += s.ship.motion.north_m / ticks;
            most_N = std::max(most_N, s.lines[1 - holds].tension_N);
        }
        EXPECT_NEAR(tension_N, std::abs(push_N), 0.01 * std::abs(push_N));
        EXPECT_NEAR(north_m, rest_m, 0.01 * std::abs(rest_m));
        EXPECT_EQ(most_N, 0.0);  // the other spring is slack
    }
}

TEST_P(MooredShip, HerLinesBringHerUpWithoutGivingHerMoreWayThanSheHad) {
    Sprung s(GetParam());
    // what half the breaking load can stop: v = T / sqrt(k m)
    const double perMetre_N = s.ship.vessel.mooring.stiffness_N / s.lines[0].length_m;
    const double began_mps =
        0.5 * s.ship.vessel.mooring.breakingLoad_N / std::sqrt(perMetre_N * s.ship.vessel.hull.mass_kg());
    s.ship.motion.surge_mps = began_mps;
    double back_mps = 0.0, most_N = 0.0;
    for (int i = 0; i < 600 * kTicksPerSecond; ++i) {
        s.tick(0.0);
        back_mps = std::max(back_mps, -s.ship.motion.surge_mps);
        most_N = std::max(most_N, s.lines[0].tension_N);
    }
    EXPECT_GT(back_mps, 0.5 * began_mps);  // lines give most of it back
    EXPECT_LT(back_mps, began_mps);
    // added mass of surge (5 %) and the tension they are made fast with add a little, damping takes a little
    EXPECT_NEAR(most_N, 0.5 * s.ship.vessel.mooring.breakingLoad_N,
                0.1 * s.ship.vessel.mooring.breakingLoad_N);
}

}  // namespace
}  // namespace sagara::core
