#include "core/world/Catenary.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

constexpr double kLength_m = 4.0 * kShackle_m, kHeight_m = 21.5;
constexpr double kWeight_Npm = 71.6, kStiffness_N = 3.38e7;  // 19 mm studlink in water
constexpr double kStiff_N = 1e18;  // does not stretch: closed forms of the plain catenary

/// Which horizontal pull just lifts the last link: s = L in s^2 = h^2 + 2 a h.
double lifts_N(double length_m = kLength_m) {
    return kWeight_Npm * (length_m * length_m - kHeight_m * kHeight_m) / (2.0 * kHeight_m);
}

/// The plain catenary under a horizontal pull, from the hyperbolic functions themselves: y = a cosh(u), u = x
/// / a.
struct Plain {
    double horizontal_N, length_m;
    double a = horizontal_N / kWeight_Npm;
    bool lies = horizontal_N <= lifts_N(length_m);
    /// half the difference and the mean of u between the ends of what hangs
    double z = lies ? 0.5 * std::acosh(1.0 + kHeight_m / a)
                    : std::asinh(std::sqrt(length_m * length_m - kHeight_m * kHeight_m) / (2.0 * a));
    double mean = lies ? z : std::atanh(kHeight_m / length_m);
    double atAnchor = mean - z, atHawse = mean + z;
    double hangs_m = a * (std::sinh(atHawse) - std::sinh(atAnchor));
    double span_m = length_m - hangs_m + 2.0 * a * z;
    /// Energy of the weight of what hangs over the ground: w times the integral of (y - y_anchor) ds.
    double energy_J() const {
        const auto upTo = [&](double u) {
            return 0.25 * std::sinh(2.0 * u) + 0.5 * u - std::cosh(atAnchor) * std::sinh(u);
        };
        return kWeight_Npm * a * a * (upTo(atHawse) - upTo(atAnchor));
    }
};

CableShape stiff(double horizontal_m, double length_m = kLength_m) {
    return cableShape(horizontal_m, kHeight_m, length_m, kWeight_Npm, kStiff_N);
}
CableShape real(double horizontal_m) {
    return cableShape(horizontal_m, kHeight_m, kLength_m, kWeight_Npm, kStiffness_N);
}

TEST(Catenary, HangsUpAndDownWithoutPullWhileThereIsCableToSpare) {
    for (const double horizontal_m : {0.0, 10.0, kLength_m - kHeight_m}) {
        const CableShape shape = real(horizontal_m);
        EXPECT_EQ(shape.horizontal_N, 0.0);
        EXPECT_EQ(shape.uplift_rad, 0.0);
        EXPECT_DOUBLE_EQ(shape.atHawse_N, kWeight_Npm * kHeight_m);
        EXPECT_DOUBLE_EQ(shape.lying_m, kLength_m - kHeight_m);
    }
}

TEST(Catenary, ACableShorterThanTheHeightCarriesOnlyItself) {
    const CableShape shape = cableShape(40.0, kHeight_m, 15.0, kWeight_Npm, kStiffness_N);
    EXPECT_EQ(shape.horizontal_N, 0.0);
    EXPECT_EQ(shape.lying_m, 0.0);
    EXPECT_DOUBLE_EQ(shape.atHawse_N, kWeight_Npm * 15.0);
}

class CatenaryUnderPull : public ::testing::TestWithParam<double> {};
TEST_P(CatenaryUnderPull, IsThePlainCatenaryWhenItDoesNotStretch) {
    const Plain plain{GetParam() * lifts_N(), kLength_m};
    const CableShape shape = stiff(plain.span_m);
    // bisection to 48 halvings of a few H: ten digits; near the straight line H depends on the ninth digit of
    // the span
    EXPECT_NEAR(shape.horizontal_N, plain.horizontal_N, 1e-6 * plain.horizontal_N);
    EXPECT_NEAR(shape.lying_m, kLength_m - plain.hangs_m, 1e-5);
    EXPECT_NEAR(std::tan(shape.uplift_rad), std::max(0.0, std::sinh(plain.atAnchor)), 1e-6);
    EXPECT_NEAR(shape.atHawse_N, plain.horizontal_N * std::cosh(plain.atHawse), 1e-6 * shape.atHawse_N);
}

TEST_P(CatenaryUnderPull, TensionAtTheHawseIsThePullAndTheWeightOfTheHeightWhileCableLies) {
    const Plain plain{GetParam() * lifts_N(), kLength_m};
    const CableShape shape = real(plain.span_m);
    if (shape.lying_m > 0.0) {
        EXPECT_DOUBLE_EQ(shape.atHawse_N, shape.horizontal_N + kWeight_Npm * kHeight_m);
    }
}

TEST_P(CatenaryUnderPull, StretchesByItsStrain) {
    const Plain plain{GetParam() * lifts_N(), kLength_m};
    const double stretched_m = plain.span_m + plain.horizontal_N * kLength_m / kStiffness_N;
    EXPECT_NEAR(real(stretched_m).horizontal_N, plain.horizontal_N, 1e-6 * plain.horizontal_N);
}

TEST_P(CatenaryUnderPull, WorkOfThePullIsTheEnergyOfTheWeightLifted) {
    const double pull_N = GetParam() * lifts_N(), step_N = 1e-3 * pull_N;
    const Plain less{pull_N - step_N, kLength_m}, more{pull_N + step_N, kLength_m};
    const double slope_N = (more.energy_J() - less.energy_J()) / (more.span_m - less.span_m);
    // central difference over 0.1 % of the pull; at the last link the slope has a kink of that order
    EXPECT_NEAR(stiff(Plain{pull_N, kLength_m}.span_m).horizontal_N, slope_N, 1e-3 * pull_N);
}
INSTANTIATE_TEST_SUITE_P(OfThatLiftingTheLastLink, CatenaryUnderPull,
                         ::testing::Values(0.01, 0.1, 0.5, 0.9, 0.999, 1.001, 1.1, 1.5, 3.0, 10.0));

TEST(Catenary, PullGrowsWithDistanceWithoutJumps) {
    CableShape before = real(0.0);
    // EA / L is the stiffest it can be: 0.31 N per micrometre; 10 mm steps
    const double most_N = 0.01 * kStiffness_N / kLength_m;
    for (double horizontal_m = 0.0; horizontal_m < kLength_m + 1.0; horizontal_m += 0.01) {
        const CableShape now = real(horizontal_m);
        ASSERT_GE(now.horizontal_N, before.horizontal_N) << horizontal_m;
        ASSERT_LE(now.horizontal_N - before.horizontal_N, most_N) << horizontal_m;
        // adds the rounding of the stretch to the slope where the last link lifts
        ASSERT_GE(now.atHawse_N, before.atHawse_N - 0.1) << horizontal_m;
        ASSERT_LE(now.atHawse_N - before.atHawse_N, 1.1 * most_N) << horizontal_m;
        ASSERT_LE(now.lying_m, before.lying_m + 1e-9) << horizontal_m;
        before = now;
    }
}

TEST(Catenary, ShapeIsContinuousWhereTheLastLinkLifts) {
    for (const double length_m : {1.05 * kHeight_m, 2.0 * kHeight_m, kLength_m}) {
        const double span_m = Plain{lifts_N(length_m), length_m}.span_m;
        const CableShape lies = stiff(span_m - 1e-6, length_m), lifted = stiff(span_m + 1e-6, length_m);
        // the slope there is at most 14 kN/m
        EXPECT_NEAR(lies.horizontal_N, lifted.horizontal_N, 0.03) << length_m;
        EXPECT_NEAR(lies.atHawse_N, lifted.atHawse_N, 0.03) << length_m;
        EXPECT_NEAR(lies.lying_m, 0.0, 1e-3) << length_m;
        EXPECT_NEAR(lifted.uplift_rad, 0.0, 1e-3) << length_m;
    }
}

TEST(Catenary, ATautCableIsASpring) {
    const double straight_m = std::sqrt(kLength_m * kLength_m - kHeight_m * kHeight_m);
    const CableShape shape = real(straight_m + 1.0);
    // what is left of the sag at 300 kN is (w L / H)^2 / 24 of the length, 3 mm: 0.3 % of the stretch
    EXPECT_NEAR(shape.horizontal_N, kStiffness_N * 1.0 / kLength_m, 0.005 * shape.horizontal_N);
    // The slope at the anchor is the chord's less half the weight.
    const double slope = kHeight_m / straight_m - 0.5 * kWeight_Npm * kLength_m / shape.horizontal_N;
    EXPECT_NEAR(std::tan(shape.uplift_rad), slope, 0.01 * slope);
}

TEST(Catenary, TwiceTheWeightAtTwiceThePullHasTheSameShape) {
    const CableShape light = stiff(100.0);
    const CableShape heavy = cableShape(100.0, kHeight_m, kLength_m, 2.0 * kWeight_Npm, kStiff_N);
    EXPECT_NEAR(heavy.horizontal_N, 2.0 * light.horizontal_N, 1e-6 * heavy.horizontal_N);
    EXPECT_NEAR(heavy.lying_m, light.lying_m, 1e-6);
}

}  // namespace
}  // namespace sagara::core
