#include "core/base/Trig.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Random.h"

namespace sagara::core {
namespace {

TEST(SinCos, AgreesWithTheLibraryToItsStatedError) {
    Random random(7);
    for (int i = 0; i < 200'000; ++i) {
        const double angle = (random.uniform() - 0.5) * std::pow(10.0, 6.0 * random.uniform());
        const SinCos sc = sinCos(angle);
        const double tolerance = 3e-14 + 3e-17 * std::abs(angle);
        ASSERT_NEAR(sc.sin, std::sin(angle), tolerance) << angle;
        ASSERT_NEAR(sc.cos, std::cos(angle), tolerance) << angle;
    }
}

TEST(SinCos, QuarterTurnsKeepTheirSigns) {
    for (int k = -8; k <= 8; ++k) {
        const SinCos sc = sinCos(k * 1.5707963267948966 + 0.1);
        EXPECT_NEAR(sc.sin, std::sin(k * 1.5707963267948966 + 0.1), 3e-14);
        EXPECT_NEAR(sc.cos, std::cos(k * 1.5707963267948966 + 0.1), 3e-14);
    }
}

}  // namespace
}  // namespace sagara::core
