#include "core/sea/Tide.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

/// Argument V + u of a constituent at an instant, in degrees: where a unit constituent with no lag stands.
double argument_deg(const char* name, const char* utc) {
    const TidePrediction now(0.0, {{name, 1.0, 0.0}}, *parseUtc(utc));
    const TidePrediction quarter(0.0, {{name, 1.0, 90.0 * kDegree_rad}}, *parseUtc(utc));
    return std::atan2(quarter.height_m({}), now.height_m({})) / kDegree_rad;
}

/// Schureman (1958), table 15: V0 + u at 0 h on 1 January stays within 1.7 to 18.6 deg for K1 (node cycle
/// of 8.9 deg about 10 deg) and within a degree of 350 for P1; S2 is 0 and S1 180 by definition.
TEST(Tide, ArgumentsAtNewYearAreThoseOfTheTables) {
    for (const char* newYear : {"2000-01-01T00:00:00Z", "2010-01-01T00:00:00Z", "2027-01-01T00:00:00Z"}) {
        EXPECT_NEAR(argument_deg("K1", newYear), 10.2, 9.5) << newYear;
        EXPECT_NEAR(argument_deg("P1", newYear), -10.0, 1.0);
        EXPECT_NEAR(argument_deg("S2", newYear), 0.0, 1e-6);
        EXPECT_NEAR(std::abs(argument_deg("S1", newYear)), 180.0, 1e-6);
    }
}

/// New moon of 2027-01-07 20:24 UTC: sun and moon pull together, so M2 and S2 of equal lag are in phase (M2
/// runs 2(h-s) behind S2, which is 0 at new moon; the mean moon is up to 6.3 deg off the true one, twice that
/// here).
TEST(Tide, SpringsFollowTheNewMoon) {
    const double m2 = argument_deg("M2", "2027-01-07T20:24:00Z"),
                 s2 = argument_deg("S2", "2027-01-07T20:24:00Z");
    EXPECT_NEAR(std::remainder(m2 - s2, 360.0), 0.0, 15.0);
}

/// The same cosine must come back after the published period of the constituent.
TEST(Tide, ConstituentsRunAtThePublishedSpeeds) {
    const struct {
        const char* name;
        double speed_degph;
    } speeds[] = {{"M2", 28.9841042}, {"S2", 30.0},         {"N2", 28.4397295}, {"K1", 15.0410686},
                  {"O1", 13.9430356}, {"K2", 30.0821373},   {"P1", 14.9589314}, {"Q1", 13.3986609},
                  {"M4", 57.9682084}, {"MM", 0.5443747},    {"SA", 0.0410686},  {"L2", 29.5284789},
                  {"T2", 29.9589333}, {"2SM2", 31.0158958}, {"MF", 1.0980331},  {"J1", 15.5854433}};
    for (const auto& s : speeds) {
        const TidePrediction tide(0.0, {{s.name, 1.0, 1.0}}, *parseUtc("2027-01-15T03:30:00Z"));
        const double period_h = 360.0 / s.speed_degph;
        const SimTime later{static_cast<std::int64_t>(20.0 * period_h * 3600e6)};
        EXPECT_NEAR(tide.height_m(later), tide.height_m({}), 2e-4) << s.name;
    }
}

TEST(Tide, UnknownNamesAreKnownToBeUnknown) {
    EXPECT_TRUE(isTidalConstituent("M2"));
    EXPECT_FALSE(isTidalConstituent("M22"));
    EXPECT_NE(tidalConstituentNames().find("LAMBDA2"), std::string::npos);
}

}  // namespace
}  // namespace sagara::core
