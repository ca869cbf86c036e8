#include "ui/input/NmeaReports.h"

#include <gtest/gtest.h>

#include "core/base/Angle.h"
#include "tests/support/exercise/Lesson.h"
#include "ui/input/NmeaSentence.h"

namespace sagara::ui {
namespace {

core::OwnShipView ahead(double heading_rad, double speed_mps) {
    core::OwnShipView ship;
    ship.motion.heading_rad = heading_rad;
    ship.motion.surge_mps = speed_mps;
    ship.overGround_mps = speed_mps * core::unitVector(heading_rad);
    return ship;
}

TEST(ApparentWind, AheadInACalmItBlowsFromTheBowWithTheShipsSpeed) {
    const ApparentWind felt = apparentWind({0.0, 0.0}, ahead(1.0, 5.0));
    EXPECT_NEAR(felt.speed_mps, 5.0, 1e-12);
    EXPECT_NEAR(core::wrapPi(felt.from_rad), 0.0, 1e-12);
}

TEST(ApparentWind, OnTheBeamItIsDrawnForward) {
    // Northerly wind, ship eastward at the same speed: from the north-east, 45 degrees on the port bow.
    const ApparentWind felt = apparentWind({8.0, 0.0}, ahead(0.5 * core::kPi, 8.0));
    EXPECT_NEAR(felt.speed_mps, 8.0 * std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(core::wrapPi(felt.from_rad), -0.25 * core::kPi, 1e-12);
}

TEST(NmeaReports, EverySentenceOfTheLessonIsRight) {
    const auto world = test::lessonWorld();
    const core::Snapshot now = core::view(*world, core::startState(*world, 1));
    const auto lines = nmeaReports(*world, now);
    std::map<std::string, NmeaSentence> byType;
    for (const std::string& line : lines) {
        const auto parsed = parseSentence(line);
        ASSERT_TRUE(parsed) << line;
        EXPECT_LE(line.size(), 80U) << line;
        byType.emplace(parsed->type, *parsed);
    }
    for (const char* type :
         {"HDT", "ROT", "VHW", "VTG", "GGA", "GLL", "ZDA", "DBT", "DPT", "MWV", "RSA", "RPM", "TRD"})
        EXPECT_EQ(byType.count(type), 1U) << type;
    const auto& shafts = world->ships[0]->vessel.propulsion.units;
    EXPECT_EQ(lines.size(), 12 + shafts.size() + world->ships[0]->vessel.thrusters.units.size());
    EXPECT_EQ(byType["TRD"].field(0), "1") << "odd: at the bow";
    EXPECT_EQ(byType["TRD"].field(1), "0.0");
    // Galle: 6 degrees north, 80 degrees east.
    EXPECT_EQ(byType["GLL"].field(0).substr(0, 2), "06");
    EXPECT_EQ(byType["GLL"].field(1), "N");
    EXPECT_EQ(byType["GLL"].field(2).substr(0, 3), "080");
    EXPECT_EQ(byType["GLL"].field(3), "E");
    const double heading_deg = std::stod(std::string(byType["HDT"].field(0)));
    const double convergence_rad = world->area.frame.convergence_rad(now.ships[0].motion.position());
    EXPECT_NEAR(
        core::wrapPi(heading_deg * core::kDegree_rad - now.ships[0].motion.heading_rad + convergence_rad),
        0.0, 0.06 * core::kDegree_rad);  // half of the last digit
}

TEST(NmeaReports, AShipThatIsNotThereSaysNothing) {
    const auto world = test::lessonWorld();
    EXPECT_TRUE(nmeaReports(*world, core::view(*world, core::startState(*world, 1)), 9).empty());
}

}  // namespace
}  // namespace sagara::ui
