// Documents whose numbers contradict each other: what is said, word for word.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/vessel/Vessel.h"
#include "tests/support/Assets.h"

namespace sagara::core {
namespace {

using nlohmann::json;

/// The problems of a shipped vessel with some numbers changed.
std::string problemsOf(const char* vessel, std::initializer_list<std::pair<const char*, json>> changes) {
    json document = json::parse(test::readAsset(std::string("vessels/") + vessel + ".json"));
    for (const auto& [path, value] : changes) document[json::json_pointer(path)] = value;
    const auto loaded = loadVessel(std::string(vessel) + ".json", document.dump());
    return loaded ? "" : loaded.error().text();
}

TEST(Plausible, DisplacementAndWaterplaneFollowTheStations) {
    EXPECT_EQ(problemsOf("s175", {{"/hull/displacement_m3", 18000}}),
              "s175.json: hull.displacement_m3 is 18000, expected 20400 to 27600 m3, by the stations");
    EXPECT_EQ(problemsOf("s175", {{"/hull/waterplaneCoefficient", 0.95}}),
              "s175.json: hull.waterplaneCoefficient is 0.95, expected 0.603 to 0.815 by the stations");
    EXPECT_EQ(problemsOf("ferry86", {{"/hull/waterplaneCoefficient", 0.45}}),
              "ferry86.json: hull.waterplaneCoefficient is 0.45, expected 0.551 to 1 with a block "
              "coefficient of 0.58");
}

TEST(Plausible, TheMetacentreIsAboveTheCentreOfGravity) {
    EXPECT_EQ(problemsOf("ferry86", {{"/hull/metacentricHeight_m", -0.4}}),
              "ferry86.json: hull.metacentricHeight_m is -0.4, expected 0.05 to 30 m");
    EXPECT_EQ(problemsOf("ferry86", {{"/hull/metacentricHeight_m", 17.4}}),
              "ferry86.json: hull.metacentricHeight_m is 17.4, expected 0.05 to 8.62 m, or the centre of "
              "gravity is below the keel");
}

TEST(Plausible, SizesGoTogether) {
    EXPECT_EQ(problemsOf("ferry86", {{"/hull/depth_m", 2.0}}),
              "ferry86.json: hull.depth_m is 2, expected 3.9 to 23.4 m with a draught of 3.9 m");
    EXPECT_EQ(problemsOf("ferry86", {{"/hull/rollGyradius_m", 0.6}, {"/hull/pitchGyradius_m", 39.0}}),
              "ferry86.json: hull.rollGyradius_m is 0.6, expected 3.12 to 9.36 m, 0.2 to 0.6 of the beam\n"
              "ferry86.json: hull.pitchGyradius_m is 39, expected 11.9 to 31.6 m, 0.15 to 0.4 of lengthBp_m");
}

TEST(Plausible, MachineryAndGearAreAboardAndOfHerSize) {
    EXPECT_EQ(problemsOf("ferry86", {{"/propulsion/units/0/diameter_m", 8.0},
                                     {"/propulsion/units/1/x_m", -80.0},
                                     {"/steering/areaEach_m2", 100.0},
                                     {"/thrusters/units/1/height_m", -25.0},
                                     {"/mooring/fairleads/2/y_m", 40.0},
                                     {"/groundTackle/anchors/0/x_m", 90.0}}),
              "ferry86.json: propulsion.units[0].diameter_m is 8, expected 0.39 to 4.68 m with a draught of "
              "3.9 m\n"
              "ferry86.json: propulsion.units[1].x_m is -80, expected -47.3 to 47.3 m, inside the ship\n"
              "ferry86.json: steering.areaEach_m2 is 100, expected 0.308 to 46.2 m2, 0.1 to 15 % of length "
              "by draught\n"
              "ferry86.json: thrusters.units[1].height_m is -25, expected -4.68 to 0 m, below the water and "
              "above the keel\n"
              "ferry86.json: mooring.fairleads[2].y_m is 40, expected -9.36 to 9.36 m, inside the ship\n"
              "ferry86.json: groundTackle.anchors[0].x_m is 90, expected -47.3 to 47.3 m, inside the ship");
}

}  // namespace
}  // namespace sagara::core
