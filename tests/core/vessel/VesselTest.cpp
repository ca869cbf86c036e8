#include "core/vessel/Vessel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "tests/support/Assets.h"
#include "tests/support/ShippedVessels.h"

namespace sagara::core {
namespace {

std::string patrol() { return test::readAsset("vessels/patrol51.json"); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::string problemsOf(const std::string& text) {
    const auto loaded = loadVessel("v.json", text);
    return loaded ? "" : loaded.error().text();
}

class ShippedVessel : public ::testing::TestWithParam<std::string> {};
TEST_P(ShippedVessel, LoadsAndNamesASourceForEveryGroup) {
    const auto vessel = loadVessel(GetParam(), test::readAsset("vessels/" + GetParam() + ".json"));
    ASSERT_TRUE(vessel) << vessel.error().text();
    EXPECT_EQ(vessel->id, GetParam());
    for (const Provenance* p :
         {&vessel->hull.provenance, &vessel->seakeeping.provenance, &vessel->propulsion.provenance,
          &vessel->steering.provenance, &vessel->windage.provenance, &vessel->mooring.provenance,
          &vessel->groundTackle.provenance}) {
        EXPECT_GT(p->source.size(), 10u);
    }
}
INSTANTIATE_TEST_SUITE_P(Assets, ShippedVessel, ::testing::ValuesIn(test::shippedVessels()),
                         [](const auto& row) { return test::testName(row.param); });

TEST(ShippedVessels, AreThoseThatWerePromisedAndTheirLike) {
    const std::vector<std::string> ids = test::shippedVessels();
    for (const char* id :
         {"patrol51", "opv48", "esso-osaka", "kvlcc2", "kvlcc2-l7", "s175", "dtmb5415", "mariner", "sr108",
          "tanker190k", "ferry86", "trawler27", "tug30", "rib8", "sail12", "yacht20"})
        EXPECT_TRUE(std::binary_search(ids.begin(), ids.end(), id)) << id;
}

TEST(Vessel, UnitsAreConvertedOnTheWayIn) {
    const Vessel v = loadVessel("patrol51", patrol()).value();
    EXPECT_NEAR(v.steering.limit_rad, 35 * kDegree_rad, 1e-12);
    EXPECT_NEAR(v.propulsion.telegraph_rps[static_cast<std::size_t>(TelegraphStep::FullAhead)], 7.0, 1e-12);
    EXPECT_NEAR(v.groundTackle.anchors[0].cableLength_m, 8 * 27.432, 1e-9);
    EXPECT_EQ(v.mooring.breakingLoad_N, 220e3);
    EXPECT_NEAR(v.hull.mass_kg(), 361998.0, 1.0);
}

TEST(Vessel, MayHaveThrustersOrNone) {
    const Vessel v = loadVessel("patrol51", patrol()).value();
    ASSERT_EQ(v.thrusters.units.size(), 1u);
    EXPECT_NEAR(v.thrusters.units[0].thrust_N, tunnelThrust_N(110e3, 0.8, 1025.0), 1e-9);
    EXPECT_EQ(v.thrusters.provenance.quality, Quality::Estimated);
    const auto tanker = loadVessel("esso-osaka", test::readAsset("vessels/esso-osaka.json"));
    EXPECT_TRUE(tanker->thrusters.units.empty());
    const std::string problems = problemsOf(
        replaced(replaced(patrol(), "\"height_m\": -1.3", "\"height_m\": 1.3"), "\"power_kW\"", "\"power\""));
    EXPECT_NE(problems.find("thrusters.units[0].height_m is 1.3, expected -30 to 0 m"), std::string::npos)
        << problems;
    EXPECT_NE(problems.find("thrusters.units[0].power_kW is missing"), std::string::npos) << problems;
}

TEST(Vessel, WrongValuesAreAllNamedWithTheirPath) {
    std::string text = replaced(patrol(), "\"beam_m\": 8.6", "\"beam_m\": \"wide\"");
    text = replaced(text, "\"diameter_m\": 1.6", "\"diameter_m\": -1.6");
    text = replaced(text, "\"limit_deg\": 35.0", "\"limmit_deg\": 35.0");
    const std::string problems = problemsOf(text);
    EXPECT_NE(problems.find("v.json: hull.beam_m is \"wide\", expected 1 to 80 m"), std::string::npos)
        << problems;
    EXPECT_NE(problems.find("v.json: propulsion.units[0].diameter_m is -1.6, expected 0.1 to 15 m"),
              std::string::npos);
    EXPECT_NE(problems.find("v.json: steering.limit_deg is missing, expected 10 to 70 deg"),
              std::string::npos);
    EXPECT_NE(problems.find("v.json: steering.limmit_deg is unknown"), std::string::npos);
}

TEST(Vessel, PhysicalNonsenseIsRefusedWithTheNumbers) {
    EXPECT_EQ(problemsOf(replaced(patrol(), "\"displacement_m3\": 357.0", "\"displacement_m3\": 3570.0")),
              "v.json: hull.displacement_m3 is 3570, a block coefficient of 3.505 with the other "
              "particulars, expected "
              "0.2 to 1");
    EXPECT_NE(problemsOf(replaced(patrol(), "\"slowAhead\": 156", "\"slowAhead\": 100"))
                  .find("telegraph_rpm.slowAhead is 100, expected more than the step below it, 102 rpm"),
              std::string::npos);
    EXPECT_NE(problemsOf(replaced(patrol(), "\"wholeBelow_mps\": 3.0", "\"wholeBelow_mps\": 5.0"))
                  .find("expected less than published.holdsFrom_mps, 4 m/s"),
              std::string::npos);
}

TEST(Vessel, ATermThatIsNotAProductIsRefused) {
    EXPECT_NE(problemsOf(replaced(patrol(), "\"of\": \"phi^3\"", "\"of\": \"phi^9\""))
                  .find("is \"phi^9\", expected up to six"),
              std::string::npos);
    std::array<PolynomialTerm::Factor, PolynomialTerm::kFactors> f{};
    EXPECT_TRUE(parseFactors("phi u^2", f));
    EXPECT_EQ(f[2], PolynomialTerm::Factor::Surge);
    EXPECT_TRUE(parseFactors("c^2 |atan(v/u)| |delta| z", f));
    EXPECT_EQ(f[2], absolute(PolynomialTerm::Factor::Sideslip));
    for (const char* bad : {"", "w", "u^4 v^3", "u^", "u^5", "|u", "u*v"})
        EXPECT_FALSE(parseFactors(bad, f)) << bad;
}

// --- several models ---

std::string withModels(const std::string& second) {
    std::string text = patrol();
    const std::size_t at = text.find("\"model\": {"), end = text.find("\"seakeeping\"");
    const std::size_t brace = text.rfind('}', end);
    const std::string group = text.substr(at + 9, brace + 1 - (at + 9));
    return text.replace(at, brace + 1 - at,
                        "\"models\": [" + group + ", " + replaced(group, "{", second) + "]");
}

TEST(Vessel, ASingleModelIsAListOfOneNamedAfterItsKind) {
    const Vessel v = loadVessel("patrol51", patrol()).value();
    ASSERT_EQ(v.models.size(), 1u);
    EXPECT_EQ(v.models[0].name, "polynomial");
    EXPECT_EQ(v.models[0].provenance.quality, Quality::Published);
}

TEST(Vessel, ModelsAreFoundByNameAndTheFirstIsTheDefault) {
    const Vessel v = loadVessel("patrol51", withModels("{ \"name\": \"fitted\",")).value();
    ASSERT_EQ(v.models.size(), 2u);
    EXPECT_EQ(v.model().value(), &v.models[0]);
    EXPECT_EQ(v.model("fitted").value(), &v.models[1]);
    EXPECT_EQ(v.model("mmg").error(), "vessel patrol51 has no model \"mmg\"; there are: polynomial, fitted");
}

TEST(Vessel, ModelsOfTheSameNameAreRefused) {
    EXPECT_EQ(problemsOf(withModels("{")),
              "v.json: models[1].name is \"polynomial\" again, expected a name of its own for each model");
    EXPECT_EQ(problemsOf(replaced(patrol(), "\"kind\": \"polynomial\"", "\"kind\": \"poly\""))
                  .find("v.json: model.kind is \"poly\", expected one of polynomial, "),
              0u);
}

TEST(Vessel, AModelHandsOverToOneThatIsThere) {
    const std::string holds =
        R"({ "holds": { "from_mps": 4, "to_mps": 9, "nothingBelow_mps": 3, "nothingAbove_mps": 11,
        "shaftFrom_rps": 1, "elsewhere": "mmg" },)";
    EXPECT_EQ(problemsOf(replaced(patrol(), "\"model\": {", "\"model\": " + holds)),
              "v.json: models has model \"polynomial\" that hands over to \"mmg\", expected a model of this "
              "vessel that holds at any speed");
    const std::string crossed = replaced(holds, "\"to_mps\": 9", "\"to_mps\": 12");
    EXPECT_NE(problemsOf(replaced(patrol(), "\"model\": {", "\"model\": " + crossed))
                  .find("v.json: model.holds.from_mps is 4, expected nothingBelow_mps, from_mps, to_mps and "
                        "nothingAbove_mps in rising order"),
              std::string::npos);
}

TEST(Vessel, ANewerDocumentIsRefusedByItsVersion) {
    EXPECT_EQ(problemsOf(replaced(patrol(), "\"version\": 1", "\"version\": 2")),
              "v.json: version is 2, expected a whole number from 1 to 1");
}

TEST(Outline, IsClosedConvexEnoughAndTheSizeOfTheShip) {
    const Vessel v = loadVessel("patrol51", patrol()).value();
    const auto outline = outlineOf(v.hull.lengthOverall_m, v.hull.beam_m);
    double x = 0.0, y = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const BodyPoint a = outline[i], b = outline[(i + 1) % outline.size()];
        EXPECT_LE(std::hypot(b.x_m - a.x_m, b.y_m - a.y_m), kOutlineStep_m + 1e-9);
        x = std::max(x, std::abs(a.x_m));
        y = std::max(y, std::abs(a.y_m));
    }
    EXPECT_DOUBLE_EQ(x, 27.0);
    EXPECT_DOUBLE_EQ(y, 4.3);
}

}  // namespace
}  // namespace sagara::core
