// The B-series against its coefficient file and check table; KT of the Esso Osaka.
#include "core/vessel/OpenWater.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"
#include "core/vessel/Vessel.h"
#include "tests/support/Assets.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

BScrew screwOf(const test::Row& row) { return {static_cast<int>(row["Z"]), row["AEA0"], row["PD"]}; }

TEST(WageningenB, IsItsCheckTable) {
    for (const test::Row& row : test::readReference("propulsion/wageningen_b_check.csv")) {
        const BScrew screw = screwOf(row);
        const double J = row["J"], KT = screw.thrustCoefficient(J), KQ = screw.torqueCoefficient(J);
        EXPECT_NEAR(KT / row["KT"], 1.0, 1e-5);
        EXPECT_NEAR(KQ / row["KQ"], 1.0, 1e-5);
        EXPECT_NEAR(J / kTwoPi * KT / KQ, row["eta0"], 1e-5);
    }
}

TEST(WageningenB, IsEveryTermOfItsCoefficientFile) {
    const auto terms = test::readReference("propulsion/wageningen_b_coefficients.csv");
    EXPECT_EQ(terms.size(), 39u + 47u);
    for (const BScrew screw : {BScrew{4, 0.55, 0.8}, BScrew{6, 0.95, 1.3}, BScrew{2, 0.30, 0.5}})
        for (const double J : {0.0, 0.37, 0.9}) {
            double KT = 0.0, KQ = 0.0;
            for (const test::Row& t : terms)
                (t.text("K") == "KT" ? KT : KQ) +=
                    t["C"] * std::pow(J, t["s"]) * std::pow(screw.pitchRatio, t["t"]) *
                    std::pow(screw.areaRatio, t["u"]) * std::pow(screw.blades, t["v"]);
            EXPECT_NEAR(screw.thrustCoefficient(J), KT, 1e-12);
            EXPECT_NEAR(screw.torqueCoefficient(J), KQ, 1e-12);
            const auto t = screw.thrustPolynomial(), q = screw.torquePolynomial();
            EXPECT_NEAR(t[0] + J * (t[1] + J * (t[2] + J * t[3])), KT, 1e-12);
            EXPECT_NEAR(q[0] + J * (q[1] + J * (q[2] + J * q[3])), KQ, 1e-12);
        }
}

std::string tanker() { return test::readAsset("vessels/esso-osaka.json"); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}
/// The Esso Osaka with a propeller known in all quadrants.
std::string tankerWith(const std::string& members) {
    return replaced(tanker(), "\"asternThrustRatio\": 0.6,", members);
}
std::string problemsOf(const std::string& text) {
    const auto loaded = loadVessel("v.json", text);
    return loaded ? "" : loaded.error().text();
}
const char* const kScrew = "\"wageningenB\": {\"blades\": 5, \"areaRatio\": 0.682, \"pitchRatio\": 0.715},";

TEST(OpenWater, ThrustOfTheEssoOsakaIsTheReportsAndTorqueTheSeries) {
    const auto vessel = loadVessel("v.json", tankerWith(kScrew));
    ASSERT_TRUE(vessel) << vessel.error().text();
    const OpenWater& water = *vessel->propulsion.units[0].openWater;
    for (const test::Row& row : test::readReference("propulsion/esso_osaka_kt_check.csv")) {
        const double J = row["J"];
        EXPECT_NEAR(water.at(J).thrust, row["KT_report"], 1e-4);
        EXPECT_NEAR(water.screw.thrustCoefficient(J), row["KT_B5_682_0715"], 1e-4);
        EXPECT_NEAR(water.at(J).torque, water.screw.torqueCoefficient(J), 1e-12);
    }
    EXPECT_NEAR(water.highestJ(), 1.097, 0.01);  // root of the report's parabola
}

TEST(OpenWater, MayBeATable) {
    const auto vessel = loadVessel(
        "v.json", tankerWith(std::string(kScrew) +
                             "\"openWater\": [[0, 0.4, 0.05], [0.5, 0.2, 0.03], [1.0, 0.0, 0.01]],"));
    ASSERT_TRUE(vessel) << vessel.error().text();
    const OpenWater& water = *vessel->propulsion.units[0].openWater;
    EXPECT_NEAR(water.at(0.25).thrust, 0.3, 1e-12);
    EXPECT_NEAR(water.at(0.75).torque, 0.02, 1e-12);
    EXPECT_EQ(water.highestJ(), 1.0);
}

TEST(OpenWater, WrongOnesSayWhereAndWhatIsAccepted) {
    EXPECT_NE(
        problemsOf(tankerWith("\"wageningenB\": {\"blades\": 9, \"areaRatio\": 2, \"pitchRatio\": 0.7},"))
            .find("propulsion.units[0].wageningenB.blades is 9, expected a whole number from 2 to 7"),
        std::string::npos);
    EXPECT_NE(
        problemsOf(tankerWith(std::string(kScrew) + "\"openWater\": [[0, 0.4, 0.05], [0.5, 0.2, 0.03]],"))
            .find("propulsion.units[0].openWater has 2 rows, expected three or more rows"),
        std::string::npos);
    EXPECT_NE(problemsOf(tankerWith("\"asternThrustRatio\": 0.6, \"pitch\": {\"least\": -0.7, \"most\": 1, "
                                    "\"rate_perS\": 0.05, \"slowest_rpm\": 50},"))
                  .find("propulsion.units[0].pitch goes with a propeller of known torque"),
              std::string::npos);
    const std::string engine =
        "\"engine\": {\"power_kW\": 26000, \"speed_rpm\": 82, \"idle_rpm\": 90, "
        "\"startAir\": {\"starts\": 0, \"refill_s\": 120}},";
    const std::string problems = problemsOf(tankerWith(kScrew + engine));
    EXPECT_NE(problems.find("engine.idle_rpm is 90, expected less than speed_rpm"), std::string::npos)
        << problems;
    EXPECT_NE(problems.find("engine.startAir.starts is 0, expected 1 to 100"), std::string::npos) << problems;
    EXPECT_NE(problemsOf(replaced(tanker(), "[ { \"x_m\": -162.5, \"y_m\": 0.0 } ]", "[]"))
                  .find("steering.rudders is empty, expected at least one rudder, or an azimuth drive"),
              std::string::npos);
}

}  // namespace
}  // namespace sagara::core
