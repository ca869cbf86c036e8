#include "render/scene/sky/Almanac.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"

namespace sagara::render {
namespace {

using core::kDegree_rad;

SkyTime at(const char* utc) { return SkyTime::of(*core::parseUtc(utc), 0.0); }

TEST(Almanac, SunOfMeeusExample25a) {
    // 1992-10-13 0h TD is 59 s later than UT; the sun moves 0.0007 deg in that time.
    const Equatorial sun = sunOnSphere(at("1992-10-12T23:59:01Z"));
    EXPECT_NEAR(sun.rightAscension_rad / kDegree_rad, 198.38083, 0.01);  // accuracy of the method
    EXPECT_NEAR(sun.declination_rad / kDegree_rad, -7.78507, 0.01);
}

TEST(Almanac, MoonOfMeeusExample47a) {
    const Equatorial moon = moonOnSphere(at("1992-04-11T23:59:01Z"));
    EXPECT_NEAR(moon.rightAscension_rad / kDegree_rad, 134.688470, 0.3);  // principal terms only
    EXPECT_NEAR(moon.declination_rad / kDegree_rad, 13.768368, 0.3);
}

TEST(Almanac, SunSeenAsInTheExampleOfTheSolarPositionAlgorithm) {
    // Reda and Andreas (2008), NREL/TP-560-34302, table A5.1: Golden, Colorado.
    const Horizontal sun = sunSeen({39.742476, -105.1786}, at("2003-10-17T19:30:30Z"));
    EXPECT_NEAR(sun.bearing_rad / kDegree_rad, 194.34024, 0.1);  // the figure asked for
    EXPECT_NEAR(sun.altitude_rad / kDegree_rad, 90.0 - 50.11162, 0.1);
}

TEST(Almanac, RefractionAtTheHorizonIs34Minutes) {
    EXPECT_NEAR(refraction_rad(-34.0 / 60.0 * kDegree_rad) / kDegree_rad * 60.0, 34.0, 1.5);
    EXPECT_NEAR(refraction_rad(45.0 * kDegree_rad) / kDegree_rad * 60.0, 1.0, 0.05);
}

TEST(Almanac, FullMoonIsLitAndNewMoonIsNot) {
    EXPECT_GT(moonSeen({6.0, 80.0}, at("2027-01-22T12:17:00Z")).litShare, 0.99);  // full moon of January 2027
    EXPECT_LT(moonSeen({6.0, 80.0}, at("2027-01-07T20:24:00Z")).litShare, 0.01);  // new moon
}

}  // namespace
}  // namespace sagara::render
