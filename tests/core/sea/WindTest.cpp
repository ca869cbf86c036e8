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

}  // namespace
}  // namespace sagara::core
