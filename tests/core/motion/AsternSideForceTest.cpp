#include "core/motion/AsternSideForce.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "core/motion/RungeKutta.h"
#include "core/motion/ShipDynamics.h"
#include "tests/support/Assets.h"

namespace sagara::core {
namespace {

const std::vector<AsternSideRow> kEssoOsaka{
    {-0.84, 0.0, 0.0}, {-0.35, -2.876e-3, 1.1445e-3}, {-0.06, -5.58e-4, 2.25e-4}};

Hull hull() {
    Hull h;
    h.lengthBp_m = 3.0;
    h.draught_m = 0.20114;
    h.waterDensity_kgpm3 = 1000.0;
    return h;
}
PropulsionUnit screw() {
    PropulsionUnit unit;
    unit.diameter_m = 0.084;
    return unit;
}
/// Y over 1/2 rho L d (n D)^2.
double sideAt(double J, double shaft_rps = -10.0, double pitch = 1.0) {
    const double tip_mps = shaft_rps * pitch * screw().diameter_m;
    const Load f = asternSideForce(kEssoOsaka, hull(), screw(), {shaft_rps, pitch}, J * tip_mps);
    return f.sway_N / (0.5 * 1000.0 * 3.0 * 0.20114 * tip_mps * tip_mps);
}

TEST(AsternSideForce, IsThePublishedFitOfEssoOsaka) {
    EXPECT_NEAR(sideAt(0.0), -5.58e-4, 1e-9);
    EXPECT_NEAR(sideAt(0.5), -5.58e-4, 1e-9) << "with sternway as at rest";
    EXPECT_NEAR(sideAt(-0.2), -7.9e-5 - 7.99e-3 * 0.2, 5e-6);   // A1 + A2 J
    EXPECT_NEAR(sideAt(-0.6), -4.93e-3 + 5.87e-3 * 0.6, 2e-5);  // A3 + A4 J
    EXPECT_EQ(sideAt(-1.5), 0.0);
}

TEST(AsternSideForce, IsThereOnlyWhileTheScrewDrivesAstern) {
    EXPECT_EQ(asternSideForce(kEssoOsaka, hull(), screw(), {10.0}, 0.3).sway_N, 0.0);
    EXPECT_EQ(asternSideForce(kEssoOsaka, hull(), screw(), {0.0}, 0.3).sway_N, 0.0);
    EXPECT_EQ(asternSideForce({}, hull(), screw(), {-10.0}, 0.0).sway_N, 0.0);
    EXPECT_NEAR(sideAt(-0.2, 10.0, -0.5), sideAt(-0.2), 1e-12) << "pitch reversed";
}

std::string textOf(const std::string& id) { return test::readAsset("vessels/" + id + ".json"); }
Vessel shipped(const std::string& id) { return loadVessel(id, textOf(id)).value(); }

/// Heading after so many seconds from rest with full astern.
double headingAfter(const Vessel& vessel, double seconds) {
    const ShipDynamics ship(vessel);
    Actuators actuators;
    for (std::size_t i = 0; i < vessel.propulsion.units.size(); ++i)
        actuators.shaft_rps[i] = vessel.propulsion.telegraph_rps.front();
    ShipMotion m;
    for (double t = 0.0; t < seconds; t += 0.1)
        m = rk4Step(m, 0.1, [&](const ShipMotion& x) { return ship.derivative(x, actuators, {}, {}); });
    return m.heading_rad / kDegree_rad;
}

TEST(AsternSideForce, ASingleScrewShipBacksWithHerBowToStarboardATwinScrewShipStraight) {
    EXPECT_GT(headingAfter(shipped("esso-osaka"), 300.0), 3.0);
    EXPECT_GT(headingAfter(shipped("kvlcc2"), 300.0), 3.0);
    EXPECT_NEAR(headingAfter(shipped("ferry86"), 120.0), 0.0, 0.1);
}

TEST(AsternSideForce, OfTwoScrewsIsAMistake) {
    std::string text = textOf("ferry86");
    const auto at = text.find("\"wake\": {");
    ASSERT_NE(at, std::string::npos);
    text.insert(at, R"("astern": {"rows": [[0, -1e-3, 1e-3]], "source": "x", "quality": "estimated"}, )");
    const auto vessel = loadVessel("ferry86", text);
    ASSERT_FALSE(vessel);
    EXPECT_NE(vessel.error().text().find("single screw"), std::string::npos) << vessel.error().text();
}

}  // namespace
}  // namespace sagara::core
