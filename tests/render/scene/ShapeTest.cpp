#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ShapeExtent.h"
#include "render/scene/light/MarkShape.h"
#include "render/scene/sea/Wake.h"
#include "render/scene/ship/ShipShape.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::render {
namespace {

/// The lesson's ship and every type of target, each 40 m long.
std::vector<ShipForm> allForms() {
    std::vector<ShipForm> forms{formOf(test::lessonWorld()->ships[0]->vessel)};
    for (int type = 0; type <= static_cast<int>(core::TargetType::FastCraft); ++type) {
        core::TargetLayout layout;
        layout.type = static_cast<core::TargetType>(type);
        layout.length_m = 40.0;
        layout.beam_m = 8.0;
        layout.draught_m = 2.5;
        forms.push_back(formOf(layout));
    }
    return forms;
}

TEST(ShipShape, HasTheLengthBeamAndDraughtOfTheShip) {
    for (const ShipForm& form : allForms()) {
        const Extent hull = extentOf(shapeOf(form, 0).hull);
        EXPECT_NEAR(hull.high.x - hull.low.x, form.length_m, 0.02 * form.length_m);
        EXPECT_NEAR(hull.high.y - hull.low.y, form.beam_m, 0.02 * form.beam_m);
        EXPECT_NEAR(hull.low.up, -form.draught_m, 1e-9);
    }
}

TEST(ShipShape, EveryTypeIsCheapAndFinite) {
    for (const ShipForm& form : allForms()) {
        for (const unsigned variant : {0u, 1u, 7u}) {
            const ShipShape shape = shapeOf(form, variant);
            EXPECT_LT(shape.hull.triangles() + shape.upperworks.triangles(), 3000u);
            for (const Solid* s : {&shape.hull, &shape.upperworks, &shape.detail}) {
                for (const std::uint32_t i : s->indices) ASSERT_LT(i, s->vertices.size());
                for (const SolidVertex& v : s->vertices) {
                    ASSERT_TRUE(std::isfinite(v.position.x + v.position.y + v.position.up));
                    ASSERT_NEAR(v.normal.x * v.normal.x + v.normal.y * v.normal.y + v.normal.up * v.normal.up,
                                1.0, 1e-6);
                }
            }
        }
    }
}

TEST(ShipShape, NothingOfTheHullStandsBetweenTheBridgeEyeAndTheSea) {
    // Seen from the eye the foredeck stays below a line 4 deg under the horizon, but for the jackstaff.
    const ShipForm form = formOf(test::lessonWorld()->ships[0]->vessel);
    int above = 0;
    for (const SolidVertex& v : shapeOf(form, 0).hull.vertices) {
        const double ahead = v.position.x - form.bridge_m;
        if (ahead > 1.0 && v.position.up > form.bridgeHeight_m - std::tan(0.07) * ahead) ++above;
    }
    EXPECT_LE(above, 16);  // the jackstaff's corners
}

TEST(MarkShape, EveryMarkOfGalleHasAShapeOfItsHeight) {
    const auto world = test::lessonWorld();  // outlives the loop
    for (const core::Mark& mark : world->area.marks) {
        if (mark.kind == core::MarkKind::Lighthouse) continue;  // among the buildings
        const Extent e = extentOf(shapeOf(mark, false));
        EXPECT_GE(e.high.up, lampHeight_m(mark) - 0.1) << mark.id;
        EXPECT_LT(e.high.up, lampHeight_m(mark) + 2.0) << mark.id;
    }
}

TEST(MarkShape, RegionBHasGreenToPort) {
    core::Mark mark;
    mark.kind = core::MarkKind::LateralPort;
    mark.floating = true;
    const auto red = [&](bool regionB) { return shapeOf(mark, regionB).vertices.front().colour.red; };
    EXPECT_GT(red(false), 0.5);
    EXPECT_LT(red(true), 0.2);
}

TEST(Wake, BendsAlongTheCircleTheShipSailsOn) {
    ShipPose pose;
    pose.speedThroughWater_mps = 6.0;
    pose.yawRate_radps = 0.02;  // to starboard: the centre is 300 m to starboard of her
    const core::NorthEast centre{-0.42 * 50.0, 300.0};
    const auto ribbons = foamOf(pose, 50.0, 9.0);
    for (const FoamPoint& p : ribbons.front())
        EXPECT_NEAR(core::distance(p.place, centre), 300.0, 0.5 * p.width_m + 0.5);
}

TEST(Wake, AShipAtRestHasNone) { EXPECT_TRUE(foamOf(ShipPose{}, 50.0, 9.0).empty()); }

}  // namespace
}  // namespace sagara::render
