// Documents that hold particulars, all of a ship or beside what is known better.
#include "core/vessel/CompleteVessel.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/base/Units.h"
#include "core/vessel/Particulars.h"
#include "core/vessel/Vessel.h"
#include "tests/support/Assets.h"

namespace sagara::core {
namespace {

using Json = nlohmann::ordered_json;

Json coaster() {
    return {{"document", "vessel"},
            {"version", 1},
            {"id", "ruhuna"},
            {"name", "MV Ruhuna"},
            {"type", "general cargo"},
            {"particulars",
             {{"lengthOverall_m", 88.0},
              {"lengthBp_m", 84.0},
              {"beam_m", 14.0},
              {"draught_m", 5.4},
              {"blockCoefficient", 0.76},
              {"speed_kn", 12.5},
              {"power_kW", 2200},
              {"source", "her builder's list"}}}};
}

std::string problemsOf(const Json& document) {
    const auto loaded = loadVessel("v.json", document.dump());
    return loaded ? "" : loaded.error().text();
}

TEST(CompleteVessel, MakesTheShipOfHerParticulars) {
    const auto vessel = loadVessel("v.json", coaster().dump());
    ASSERT_TRUE(vessel) << vessel.error().text();
    EXPECT_EQ(vessel->id, "ruhuna");
    EXPECT_TRUE(std::holds_alternative<MmgModel>(vessel->models.at(0).parameters));
    EXPECT_EQ(vessel->models[0].provenance.quality, Quality::Estimated);
    EXPECT_NE(vessel->hull.provenance.source.find("her builder's list"), std::string::npos);
    EXPECT_TRUE(vessel->propulsion.units.at(0).openWater);  // four quadrants, torque
    ASSERT_TRUE(vessel->propulsion.units[0].engine);
    const Engine& engine = *vessel->propulsion.units[0].engine;
    EXPECT_NEAR(kTwoPi * engine.torque_Nm * engine.full_rps, 2.2e6, 2e3);
    EXPECT_FALSE(engine.startAir);  // geared
}

TEST(CompleteVessel, TakesWhatIsKnownOfFormAndRudder) {
    Json document = coaster();
    document["particulars"]["depth_m"] = 7.1;
    document["particulars"]["metacentricHeight_m"] = 0.83;
    document["particulars"]["rudders"] = 2;
    document["particulars"]["rudderArea_m2"] = 9.6;
    const auto vessel = loadVessel("v.json", document.dump());
    ASSERT_TRUE(vessel) << vessel.error().text();
    EXPECT_EQ(vessel->hull.depth_m, 7.1);
    EXPECT_EQ(vessel->hull.metacentricHeight_m, 0.83);
    EXPECT_EQ(vessel->steering.areaEach_m2, 4.8);
    document["particulars"]["rudderArea_m2"] = 96.0;
    document["particulars"]["depth_m"] = 5.0;
    EXPECT_EQ(problemsOf(document),
              "v.json: particulars.depth_m is 5, expected 5.67 to 27 m\n"
              "v.json: particulars.rudderArea_m2 is 96, expected 2.27 to 45.36 m2");
}

TEST(CompleteVessel, ACraftFastForHerWeightPlanes) {
    EXPECT_FALSE(loadVessel("v.json", coaster().dump())->planing);
    Json document = coaster();
    document["type"] = "fast craft";
    document["particulars"] = {
        {"lengthOverall_m", 12.0}, {"lengthBp_m", 10.8}, {"beam_m", 3.6},   {"draught_m", 0.8},
        {"blockCoefficient", 0.4}, {"speed_kn", 32},     {"power_kW", 600}, {"shafts", 2}};
    const auto boat = loadVessel("v.json", document.dump());
    ASSERT_TRUE(boat) << boat.error().text();
    ASSERT_TRUE(boat->planing);
    EXPECT_EQ(boat->planing->provenance.quality, Quality::Estimated);
}

TEST(CompleteVessel, LeavesWhatTheDocumentHas) {
    Json document = coaster();
    const Json patrol = Json::parse(test::readAsset("vessels/patrol51.json"));
    document["windage"] = patrol["windage"];
    document["hull"] = {{"bilgeKeelLength_m", 0.0}, {"metacentricHeight_m", 0.9}};
    document["models"] = Json::array({{{"kind", "nomoto"}}});
    const Json whole = Json::parse(*completeVessel("v.json", document.dump()));
    EXPECT_EQ(whole["windage"], patrol["windage"]);
    EXPECT_EQ(whole["hull"]["bilgeKeelLength_m"], 0.0);
    EXPECT_EQ(whole["hull"]["metacentricHeight_m"], 0.9);
    EXPECT_EQ(whole["hull"]["beam_m"], 14.0);
    EXPECT_EQ(whole["models"], document["models"]);
    EXPECT_FALSE(whole.contains("model"));
    EXPECT_FALSE(whole.contains("particulars"));
}

TEST(CompleteVessel, SaysWhereItIsWrongInTheDocumentsOwnWords) {
    Json document = coaster();
    document["particulars"]["power_kW"] = 30;
    EXPECT_NE(problemsOf(document).find("v.json: particulars.power_kW is 30 kW, expected at least "),
              std::string::npos);
    const std::string told = problemsOf(document);
    const double least_kW = std::stod(told.substr(told.find("at least ") + 9));
    document["particulars"]["power_kW"] = least_kW;  // what is told is accepted
    EXPECT_EQ(problemsOf(document), "");
    document = coaster();
    document["particulars"].erase("speed_kn");
    document["particulars"]["speed_mps"] = 6.0;
    EXPECT_NE(problemsOf(document).find("particulars.speed_kn is missing, expected 4 to 48 kn"),
              std::string::npos);
    EXPECT_NE(problemsOf(document).find("particulars.speed_mps is unknown"), std::string::npos);
    document = coaster();
    document["type"] = "coaster";
    EXPECT_NE(problemsOf(document).find("v.json: type is \"coaster\", expected one of tanker, "),
              std::string::npos);
    document["particulars"]["kind"] = "general cargo";  // then the type is free
    EXPECT_EQ(problemsOf(document), "");
    document["particulars"] = 7;
    EXPECT_NE(problemsOf(document).find("v.json: particulars is 7, expected an object"), std::string::npos);
    document.erase("particulars");
    EXPECT_NE(problemsOf(document).find("v.json: model is missing, expected a manoeuvring model, or "
                                        "\"particulars\" from which one is estimated"),
              std::string::npos);
}

TEST(CompleteVessel, LeavesOtherTextsAlone) {
    const std::string patrol = test::readAsset("vessels/patrol51.json");
    EXPECT_EQ(*completeVessel("v.json", patrol), patrol);
    EXPECT_EQ(*completeVessel("v.json", "not json"), "not json");
}

}  // namespace
}  // namespace sagara::core
