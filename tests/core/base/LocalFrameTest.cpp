#include "core/base/LocalFrame.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

const LocalFrame kGalle({6.02, 80.228});

TEST(LocalFrame, GoesThereAndBack) {
    const GeoPoint p = kGalle.toGeo(kGalle.toLocal({6.0072, 80.2275}));
    EXPECT_NEAR(p.lat_deg, 6.0072, 1e-12);
    EXPECT_NEAR(p.lon_deg, 80.2275, 1e-12);
    EXPECT_EQ(length(kGalle.toLocal(kGalle.datum())), 0.0);
}

/// WGS 84 meridian: a degree of latitude is 111 132.954 - 559.822 cos 2 phi + 1.175 cos 4 phi m; at phi
/// = 6.028 deg a minute is 1843.109 m, last digit printed.
TEST(LocalFrame, OneMinuteOfLatitudeHasThePublishedLength) {
    EXPECT_NEAR(kGalle.toLocal({6.02 + 1.0 / 60.0, 80.228}).north_m, 1843.109, 0.001);
}

TEST(LocalFrame, ConvergenceIsTheSineOfLatitudeTimesLongitudeDifference) {
    const NorthEast p = kGalle.toLocal({6.02, 80.328});
    // Along a geodesic that starts eastward the azimuth grows by delta lambda sin phi (spherical, small arc;
    // the ellipsoid changes it by less than the flattening).
    const double expected_rad = -0.1 * kDegree_rad * std::sin(6.02 * kDegree_rad);
    EXPECT_NEAR(kGalle.convergence_rad(p), expected_rad, 0.0034 * std::abs(expected_rad));
    EXPECT_EQ(kGalle.convergence_rad({}), 0.0);
}

}  // namespace
}  // namespace sagara::core
