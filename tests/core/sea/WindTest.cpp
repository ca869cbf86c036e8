#include "core/sea/Wind.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

const WindParameters kBreeze{4.5, 45.0 * kDegree_rad, 0.15};

TEST(Wind, GustsHaveTheStatedSpreadAboutTheMean) {
    const GustTable gusts(1);
    double sum = 0.0, sum2 = 0.0;
    const int samples = 20'000;
    for (int i = 0; i < samples; ++i) {
        const double speed = gusts.at(kBreeze, SimTime::fromSeconds(i * 3)).speed_mps;
        sum += speed;
        sum2 += speed * speed;
    }
    const double mean = sum / samples;
    EXPECT_NEAR(mean, 4.5, 0.02);  // 200 cycles of the slowest harmonic
    EXPECT_NEAR(std::sqrt(sum2 / samples - mean * mean), 0.15 * 4.5, 0.02);
}

TEST(Wind, SteadyWindHasNoGusts) {
    const GustTable gusts(1);
    const WindVelocity now = gusts.at({10.0, 1.0, 0.0}, SimTime::fromSeconds(77));
    EXPECT_EQ(now.speed_mps, 10.0);
    EXPECT_EQ(now.windFrom_rad, 1.0);
}

TEST(Wind, NeverBlowsBackwards) {
    const GustTable gusts(2);
    for (int i = 0; i < 5000; ++i)
        EXPECT_GE(gusts.at({5.0, 0.0, 0.6}, SimTime::fromSeconds(i)).speed_mps, 0.0);
}

TEST(Wind, GustSpectraHoldTheVarianceTheirAuthorsGive) {
    for (const double wind_mps : {10.0, 20.0}) {
        const double friction2 = seaDragCoefficient(wind_mps) * wind_mps * wind_mps;
        double variance[4] = {};
        const double step = 0.001;
        for (double lnf = std::log(1e-7); lnf < std::log(1e3); lnf += step) {
            const double f = std::exp(lnf);
            for (int i = 0; i < 4; ++i)
                variance[i] += gustDensity(static_cast<GustSpectrum>(i), f, wind_mps) * f * step;
        }
        EXPECT_NEAR(variance[0] / friction2, 6.0, 0.06);           // Davenport: closed form 6
        EXPECT_NEAR(variance[1] / friction2, 6.68, 0.1);           // Harris: 4 x integral (2+x^2)^(-5/6) dx
        EXPECT_NEAR(variance[2] / friction2, 105.0 / 22.0, 0.05);  // Kaimal: 105/33 x 3/2
    }
}

TEST(Wind, FroyaDensityAtItsReferenceIsThePrintedOne) {
    EXPECT_NEAR(gustDensity(GustSpectrum::Froya, 1.0 / 172.0, 10.0),
                320.0 / std::pow(2.0, 5.0 / (3.0 * 0.468)), 1e-9);
}

TEST(Wind, EveryGustSpectrumHasTheStatedSpread) {
    for (int i = 0; i < 4; ++i) {
        const GustTable gusts(1, static_cast<GustSpectrum>(i));
        double sum = 0.0, sum2 = 0.0;
        const int samples = 20'000;
        for (int k = 0; k < samples; ++k) {
            const double speed = gusts.at(kBreeze, SimTime::fromSeconds(k * 3)).speed_mps;
            sum += speed;
            sum2 += speed * speed;
        }
        EXPECT_NEAR(std::sqrt(sum2 / samples - sum * sum / samples / samples), 0.15 * 4.5, 0.02) << i;
    }
}

TEST(Wind, ProfilesAreOneAtTenMetresAndGrowUpward) {
    for (int i = 0; i < 4; ++i) {
        const auto profile = static_cast<WindProfile>(i);
        EXPECT_EQ(windFactorAt(10.0, profile, 12.0), 1.0);
        EXPECT_LE(windFactorAt(3.0, profile, 12.0), 1.0);
        EXPECT_GE(windFactorAt(40.0, profile, 12.0), 1.0);
        EXPECT_GT(windFactorAt(0.0, profile, 12.0), 0.5);
    }
    // NORSOK N-003: 1 + 0.0573 sqrt(1 + 0.15 x 20) ln 4
    EXPECT_NEAR(windFactorAt(40.0, WindProfile::Froya, 20.0), 1.1589, 1e-4);
}

}  // namespace
}  // namespace sagara::core
