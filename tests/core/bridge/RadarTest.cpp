#include "core/bridge/Radar.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../world/SmallAreas.h"

namespace sagara::core {
namespace {

constexpr RadarSet kSet;  // antenna 15 m above the water

class RadarScreen : public ::testing::Test {
protected:
    RadarPicture picture;
    void turn(const Area& area, std::vector<RadarObject> objects, NorthEast antenna, double range_M,
              const RadarSet& set = kSet) {
        const RadarCoast coast(area);
        picture.clear(range_M * kNauticalMile_m);
        sweepRadar(coast, objects, antenna, set, 0, RadarPicture::kAzimuths, 1, picture);
    }
    std::size_t cellOf(double range_m) const { return static_cast<std::size_t>(range_m / picture.cell_m()); }
    bool lit(std::size_t azimuth, double range_m) const { return picture.at(azimuth, cellOf(range_m)) > 0; }
    static RadarObject point(NorthEast at, double crossSection_m2 = 100.0, double height_m = 10.0) {
        return {.position = at, .height_m = height_m, .crossSection_m2 = crossSection_m2};
    }
};

TEST_F(RadarScreen, APointIsABeamWideAndAPulseLong) {
    // 045 degrees, 2000 m: azimuth 180 of 1440; the beam of 1.2 degrees is two and a half steps each way.
    turn(test::openWater(20.0), {point(2000.0 * unitVector(kPi / 4.0))}, {}, 1.5);
    EXPECT_TRUE(lit(180, 2005.0));
    EXPECT_TRUE(lit(178, 2005.0));
    EXPECT_TRUE(lit(182, 2005.0));
    EXPECT_FALSE(lit(177, 2005.0));
    EXPECT_FALSE(lit(183, 2005.0));
    EXPECT_FALSE(lit(180, 2000.0 - 2.0 * picture.cell_m()));
    EXPECT_NEAR(radarEcho_m(picture.range_m), 37.5, 0.1);  // 0.25 microseconds, half of it
    EXPECT_TRUE(lit(180, 2000.0 + 32.0));
    EXPECT_FALSE(lit(180, 2000.0 + 45.0));
}

TEST_F(RadarScreen, TwoEchoesPartWhenTheyAreABeamOrAPulseApart) {
    const auto at = [](double bearing_deg, double range_m) {
        return point(range_m * unitVector(bearing_deg * kDegree_rad));
    };
    const auto gap = [&](double from_deg, double to_deg) {
        for (auto a = static_cast<std::size_t>(4.0 * from_deg); a <= static_cast<std::size_t>(4.0 * to_deg);
             ++a)
            if (!lit(a, 1505.0)) return true;
        return false;
    };
    turn(test::openWater(20.0), {at(90.0, 1500.0), at(91.0, 1500.0)}, {}, 1.5);
    EXPECT_FALSE(gap(90.0, 91.0)) << "a degree apart: one echo";
    turn(test::openWater(20.0), {at(90.0, 1500.0), at(93.0, 1500.0)}, {}, 1.5);
    EXPECT_TRUE(gap(90.0, 93.0)) << "three degrees apart: two";
    turn(test::openWater(20.0), {at(90.0, 1500.0), at(90.0, 1525.0)}, {}, 1.5);
    EXPECT_TRUE(lit(360, 1520.0)) << "25 m apart: one";
    turn(test::openWater(20.0), {at(90.0, 1500.0), at(90.0, 1580.0)}, {}, 1.5);
    EXPECT_FALSE(lit(360, 1560.0)) << "80 m apart: two";
    EXPECT_TRUE(lit(360, 1590.0));
}

TEST_F(RadarScreen, AStraightCoastLiesWhereGeometryPutsIt) {
    turn(test::longQuay(), {}, {1000.0, 0.0}, 1.5);  // land from 0 to 500 m south of north 0
    EXPECT_FALSE(lit(720, 990.0));
    EXPECT_TRUE(lit(720, 1005.0));
    EXPECT_TRUE(lit(720, 1400.0)) << "the ground behind, seen from 15 m";
    EXPECT_FALSE(lit(720, 1700.0)) << "water again";
    EXPECT_FALSE(lit(540, 1390.0)) << "the beam of 1.2 degrees comes upon it at 1402 m";
    EXPECT_TRUE(lit(540, 1000.0 * std::sqrt(2.0) + 10.0)) << "south-east: root two as far";
    EXPECT_FALSE(lit(0, 1000.0));
}

TEST_F(RadarScreen, AHillHidesWhatLiesBehindIt) {
    Area area = test::longQuay();
    const std::vector<RadarObject> boat{point({-1500.0, 0.0}, 1000.0, 10.0)};
    turn(area, boat, {1000.0, 0.0}, 1.5);
    EXPECT_TRUE(lit(720, 2505.0)) << "over land 3 m high";
    area.elevation.push_back(Grid({-3000.0, -3000.0}, 6000.0, 2, 2, std::vector<float>(4, 60.0F)));
    turn(area, boat, {1000.0, 0.0}, 1.5);
    EXPECT_FALSE(lit(720, 2505.0)) << "over land 60 m high";
    turn(area, {point({-1500.0, 0.0}, 1000.0, 140.0)}, {1000.0, 0.0}, 1.5);
    EXPECT_TRUE(lit(720, 2505.0)) << "60 m at 1.0 km is 127 m at 2.5 km, seen from 15 m";
}

TEST_F(RadarScreen, TheHorizonIsThatOfFourThirdsOfTheEarth) {
    // 2.22 M for the root of each metre: Bole, Wall and Norris, Radar and ARPA Manual.
    EXPECT_NEAR(radarHorizon_m(1.0) / kNauticalMile_m, 2.22, 0.01);
    // Antenna 15 m, object 0.5 m: 8.60 + 1.57 = 10.2 M.
    turn(test::openWater(20.0), {point({10.0 * kNauticalMile_m, 0.0}, 1e6, 0.5)}, {}, 12.0);
    EXPECT_TRUE(lit(0, 10.0 * kNauticalMile_m + 30.0));
    turn(test::openWater(20.0), {point({10.5 * kNauticalMile_m, 0.0}, 1e6, 0.5)}, {}, 12.0);
    EXPECT_FALSE(lit(0, 10.5 * kNauticalMile_m + 30.0));
}

TEST_F(RadarScreen, ASmallBoatShowsOutToThreeMiles) {
    // IMO MSC.192(79) table 2: 10 m2 at 4.9 M, 2.5 m2 at 3.4 M; the fourth root puts the second at 3.46 M.
    EXPECT_NEAR(leastCrossSection_m2(4.9 * kNauticalMile_m), 10.0, 1e-9);
    EXPECT_NEAR(leastCrossSection_m2(3.465 * kNauticalMile_m), 2.5, 0.01);
    turn(test::openWater(20.0), {point({2.9 * kNauticalMile_m, 0.0}, 2.5, 5.0)}, {}, 6.0);
    EXPECT_TRUE(lit(0, 2.9 * kNauticalMile_m + 20.0));
    turn(test::openWater(20.0), {point({4.2 * kNauticalMile_m, 0.0}, 2.5, 5.0)}, {}, 6.0);
    EXPECT_FALSE(lit(0, 4.2 * kNauticalMile_m + 20.0));
}

TEST_F(RadarScreen, AShipShowsTheSideSheTurnsToTheAntenna) {
    RadarObject ship{{1000.0, 0.0}, kPi / 2.0, 100.0, 15.0, 15.0, 2000.0};  // beam on, heads east
    turn(test::openWater(20.0), {ship}, {}, 0.75);
    // Half her length is 50 m at 992 m: 2.9 degrees, and half a beam more.
    EXPECT_TRUE(lit(11, 995.0));
    EXPECT_FALSE(lit(16, 995.0));
    ship.heading_rad = 0.0;
    turn(test::openWater(20.0), {ship}, {}, 0.75);
    EXPECT_TRUE(lit(0, 953.0)) << "end on: her stern is 50 m nearer";
    EXPECT_FALSE(lit(8, 953.0));
}

TEST_F(RadarScreen, OnlyTheSweptAzimuthsAreRenewed) {
    const Area area = test::openWater(20.0);
    const RadarCoast coast(area);
    const std::vector<RadarObject> two{point({1000.0, 0.0}), point({0.0, 1000.0})};
    picture.clear(1852.0);
    sweepRadar(coast, two, {}, kSet, 1400, 100, 1, picture);  // round the north
    EXPECT_TRUE(lit(0, 1005.0));
    EXPECT_FALSE(lit(360, 1005.0));
    sweepRadar(coast, two, {}, kSet, 300, 100, 1, picture);
    EXPECT_TRUE(lit(0, 1005.0)) << "the old echo stays";
    EXPECT_TRUE(lit(360, 1005.0));
}

}  // namespace
}  // namespace sagara::core
