#include "render/scene/light/DayShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace sagara::render {
namespace {

using core::Activity;

ShipForm ship(double length_m) {
    core::TargetLayout t;
    t.type = core::TargetType::Coaster;
    t.length_m = length_m;
    t.beam_m = length_m / 6.0;
    t.draught_m = length_m / 18.0;
    return formOf(t);
}

/// From the top: o ball, ^ and v cones by their apex, d diamond.
std::string hoisted(double length_m, Activity activity) {
    std::string text;
    for (const DayShape& shape : dayHoistOf(ship(length_m), activity).shapes)
        text += "o^vd"[static_cast<int>(shape.kind)];
    return text;
}

struct Row {
    const char* rule;
    double length_m;
    Activity activity;
    const char* fromTop;
};
const Row kRows[] = {
    {"24a towing up to 200 m", 30, Activity::Towing, ""},
    {"25 sailing", 14, Activity::Sailing, ""},
    {"26b trawling", 24, Activity::Trawling, "v^"},
    {"26c fishing", 10, Activity::Fishing, "v^"},
    {"27a not under command", 78, Activity::NotUnderCommand, "oo"},
    {"27b restricted", 30, Activity::Restricted, "odo"},
    {"27g not required under 12 m", 11, Activity::NotUnderCommand, ""},
    {"27g nor restricted", 11, Activity::Restricted, ""},
    {"30a anchored", 78, Activity::Anchored, "o"},
    {"30a anchored boat", 7, Activity::Anchored, "o"},
    {"30e not required under 7 m", 6, Activity::Anchored, ""},
    {"moored", 78, Activity::Moored, ""},
    {"23 under way", 78, Activity::UnderWay, ""},
};
class ShapesByRule : public ::testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(Colreg, ShapesByRule, ::testing::ValuesIn(kRows), [](const auto& row) {
    std::string name = row.param.rule;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});
TEST_P(ShapesByRule, AreHoisted) {
    EXPECT_EQ(hoisted(GetParam().length_m, GetParam().activity), GetParam().fromTop);
}

TEST(DayShapes, HaveTheSizesAndDistancesOfAnnexI) {
    for (const double length_m : {20.0, 54.0, 190.0}) {
        for (const Activity activity : {Activity::NotUnderCommand, Activity::Restricted}) {
            const auto shapes = dayHoistOf(ship(length_m), activity).shapes;
            for (std::size_t i = 0; i < shapes.size(); ++i) {
                EXPECT_GE(shapes[i].diameter_m, 0.6);
                if (i == 0) continue;
                const double between_m = shapes[i - 1].centre.up - shapes[i].centre.up -
                                         0.5 * (shapes[i - 1].height_m() + shapes[i].height_m());
                EXPECT_NEAR(between_m, 1.5, 1e-9);
            }
        }
    }
}

TEST(DayShapes, ConesOfWhoFishesTouchWithTheirApexes) {
    const auto cones = dayHoistOf(ship(24.0), Activity::Fishing).shapes;
    ASSERT_EQ(cones.size(), 2u);
    EXPECT_NEAR(cones[0].centre.up - cones[1].centre.up, cones[0].height_m(), 1e-9);
}

TEST(DayShapes, TheAnchorBallIsInTheForePartAndTheOthersAboveTheBridge) {
    const ShipForm form = ship(78.0);
    EXPECT_GT(dayHoistOf(form, Activity::Anchored).shapes[0].centre.x, 0.3 * form.length_m);
    EXPECT_GT(dayHoistOf(form, Activity::Restricted).shapes.back().centre.up, form.bridgeHeight_m + 1.0);
}

TEST(DayShapes, AHoistIsBlackAndOfFewTriangles) {
    const DayHoist hoist = dayHoistOf(ship(78.0), Activity::Restricted);
    const Solid solid = solidOf(hoist);
    EXPECT_LT(solid.triangles(), 250u);
    double low = 1e9, high = -1e9;
    for (const SolidVertex& v : solid.vertices) {
        EXPECT_LT(v.colour.red, 0.3);
        low = std::min(low, v.position.up);
        high = std::max(high, v.position.up);
    }
    const double origin = hoist.shapes.back().centre.up;
    EXPECT_NEAR(low, hoist.footUp_m - origin, 0.03);
    EXPECT_NEAR(high, hoist.headUp_m - origin, 0.03);
    EXPECT_GT(hoist.headUp_m, hoist.shapes.front().centre.up + 0.5 * hoist.shapes.front().height_m());
    EXPECT_TRUE(solidOf({}).indices.empty());
}

}  // namespace
}  // namespace sagara::render
