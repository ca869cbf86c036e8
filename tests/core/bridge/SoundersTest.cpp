// Echo sounder and forward-looking sonar against cases worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "../world/SmallAreas.h"
#include "core/bridge/EchoSounder.h"
#include "core/bridge/Sonar.h"

namespace sagara::core {
namespace {

/// Depth falls by `slope` for every metre north.
Area slope(double atOrigin_m, double slope) {
    Area area;
    const auto south = static_cast<float>(atOrigin_m + 1000.0 * slope),
               north = static_cast<float>(atOrigin_m - 1000.0 * slope);
    area.depths.push_back(Grid({-1000.0, -1000.0}, 2000.0, 2, 2, {south, south, north, north}));
    return area;
}

const EchoSounder kSounder{.transducer = {10.0, 0.0}, .draught_m = 2.0};

TEST(EchoSounding, OnAFlatBottomIsDepthPlusTideLessTheTransducers) {
    EXPECT_NEAR(*soundedDepth_m(test::openWater(12.0), kSounder, {}, 0.0), 10.0, 1e-6);
    EXPECT_NEAR(*soundedDepth_m(test::openWater(12.0), kSounder, {}, 0.5), 10.5, 1e-6);
}

TEST(EchoSounding, IsTakenAtTheTransducer) {
    ShipMotion heading;
    const Area area = slope(12.0, 0.01);
    EchoSounder narrow = kSounder;
    narrow.halfBeam_rad = 1e-4;
    EXPECT_NEAR(*soundedDepth_m(area, narrow, heading, 0.0), 12.0 - 0.1 - 2.0, 1e-3);
    heading.heading_rad = kPi;
    EXPECT_NEAR(*soundedDepth_m(area, narrow, heading, 0.0), 12.0 + 0.1 - 2.0, 1e-3);
    heading.pitch_rad = 0.02;  // bow up: 10 m ahead it is 0.2 m higher
    EXPECT_NEAR(*soundedDepth_m(area, narrow, heading, 0.0), 12.1 - 1.8, 1e-3);
    heading.down_m = 0.3;
    EXPECT_NEAR(*soundedDepth_m(area, narrow, heading, 0.0), 12.1 - 2.1, 1e-3);
}

TEST(EchoSounding, TakesTheShallowestWithinItsBeam) {
    // On a slope of 0.3 the nearest point of the bottom is 10 cos(16.7 deg) = 9.58 m away; the beam of
    // 10 degrees reaches to where it is sqrt((10 - 0.3 x 1.763)^2 + 1.763^2) = 9.63 m.
    EchoSounder middle = kSounder;
    middle.transducer = {};
    EXPECT_NEAR(*soundedDepth_m(slope(12.0, 0.3), middle, {}, 0.0), 9.634, 0.005);
}

TEST(EchoSounding, GivesNothingTooNearOrTooFar) {
    EXPECT_FALSE(soundedDepth_m(test::openWater(2.2), kSounder, {}, 0.0));
    EXPECT_FALSE(soundedDepth_m(test::openWater(1.0), kSounder, {}, 0.0));
    EXPECT_FALSE(soundedDepth_m(test::openWater(250.0), kSounder, {}, 0.0));
}

const Sonar kSonar{{}, 2.0};
constexpr std::size_t kAhead = 45;

double furthest_m(const SonarPicture& picture, std::size_t beam) {
    double range_m = 0.0;
    for (std::size_t cell = 0; cell < SonarPicture::kCells; ++cell)
        if (!std::isnan(picture.bottom_m[picture.index(beam, cell)]))
            range_m = (static_cast<double>(cell) + 0.5) * picture.cell_m();
    return range_m;
}

TEST(ForwardSonar, SeesAFlatBottomOutToSomeElevenDepths) {
    EXPECT_NEAR(bottomEcho_dB(110.0, std::atan(1.0 / 11.0), 0.0), 0.0, 4.0);
    const SonarPicture picture = ping(test::openWater(12.0), {}, kSonar, {}, 0.0, 200.0, 1);
    EXPECT_NEAR(picture.bottom_m[picture.index(kAhead, 50)], 12.0, 1e-4);
    EXPECT_NEAR(furthest_m(picture, kAhead), 110.0, 25.0);  // 10 m below the transducer; noise of 3 dB
}

TEST(ForwardSonar, SaysWhereItGetsShallowAhead) {
    const Area area = slope(12.0, 0.04);  // 8 m at 100 m ahead, 5 m at 175 m
    const SonarPicture picture = ping(area, {}, kSonar, {}, 0.0, 200.0, 1);
    const auto shoal_m = shoalAhead_m(picture, 8.0, 1.0 * kDegree_rad);
    ASSERT_TRUE(shoal_m);
    EXPECT_NEAR(*shoal_m, 100.0, 3.0);
    EXPECT_FALSE(shoalAhead_m(ping(test::openWater(12.0), {}, kSonar, {}, 0.0, 200.0, 1), 8.0, 1.0));
}

TEST(ForwardSonar, MarksAHullWhereSheIs) {
    ShipMotion m;
    m.heading_rad = kPi / 2.0;  // east
    const SonarObject boat{120.0 * unitVector(110.0 * kDegree_rad), 0.0, 10.0, 3.0, 1.2};
    const SonarPicture picture = ping(test::openWater(40.0), {&boat, 1}, kSonar, m, 0.0, 200.0, 1);
    ASSERT_EQ(picture.found.size(), 1u);
    EXPECT_NEAR(picture.found[0].range_m, 120.0, 5.0);  // her nearer end
    EXPECT_NEAR(picture.found[0].bearing_rad / kDegree_rad, 20.0, 2.5);
    const auto cell = static_cast<std::size_t>(120.0 / picture.cell_m());
    EXPECT_GT(picture.contacts[picture.index(kAhead + 20, cell)], 0);
    EXPECT_EQ(picture.contacts[picture.index(kAhead - 20, cell)], 0);
}

TEST(ForwardSonar, DoesNotSeeAbaftItsSectorNorBehindLandNorBeyondItsReach) {
    const auto seen = [](const Area& area, NorthEast at, double range_m) {
        const SonarObject boat{at, 0.0, 10.0, 3.0, 1.2};
        return ping(area, {&boat, 1}, kSonar, {}, 0.0, range_m, 1).found.size();
    };
    const Area open = test::openWater(40.0);
    EXPECT_EQ(seen(open, {100.0, 0.0}, 600.0), 1u);
    EXPECT_EQ(seen(open, {100.0, 120.0}, 600.0), 0u) << "50 degrees on the bow";
    EXPECT_EQ(seen(open, {-100.0, 0.0}, 600.0), 0u);
    EXPECT_EQ(seen(open, {550.0, 0.0}, 600.0), 0u) << "a boat of 10 m";
    Area bank = open;  // dries 60 to 80 m ahead
    std::vector<float> depths(101 * 101, 40.0F);
    for (std::size_t column = 0; column <= 100; ++column)
        for (const std::size_t row : {53u, 54u}) depths[101 * row + column] = -1.0F;
    bank.depths = {Grid({-1000.0, -1000.0}, 20.0, 101, 101, depths)};
    EXPECT_EQ(seen(bank, {150.0, 0.0}, 600.0), 0u);
}

TEST(ForwardSonar, ItsOwnFlowDrownsTheEchoesOfAFastShip) {
    EXPECT_EQ(bottomEcho_dB(80.0, 0.2, 0.0), bottomEcho_dB(80.0, 0.2, 8.0 * kKnot_mps));
    EXPECT_NEAR(bottomEcho_dB(80.0, 0.2, 0.0) - bottomEcho_dB(80.0, 0.2, 12.0 * kKnot_mps), 6.0, 1e-9);
}

}  // namespace
}  // namespace sagara::core
