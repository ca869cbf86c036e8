#include <gtest/gtest.h>

#include <cmath>

#include "render/scene/land/Buildings.h"
#include "render/scene/land/LandMesh.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::render {
namespace {

class GalleLand : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        s_world = test::lessonWorld();
        s_ground = std::make_unique<Ground>(s_world->area);
    }
    static inline std::shared_ptr<const core::World> s_world;
    static inline std::unique_ptr<Ground> s_ground;
};

TEST_F(GalleLand, KnowsLandFromWaterAsTheAreaDoes) {
    const core::Area& area = s_world->area;
    int differs = 0, looked = 0;
    for (double north = -3000.0; north < 3000.0; north += 75.0) {
        for (double east = -3000.0; east < 3000.0; east += 75.0, ++looked) {
            const core::NorthEast p{north, east};
            const double inland_m = s_ground->spot(p).inland_m;
            if (std::abs(inland_m) > 5.0 && (inland_m > 0.0) != area.isLand(p)) ++differs;
        }
    }
    EXPECT_LE(differs, looked / 1000) << "of " << looked;
}

TEST_F(GalleLand, TheQuayIsFlatAndItsFaceStandsWhereTheBerthIs) {
    const core::Berth& berth = *s_world->area.findBerth("new-pier");
    const core::NorthEast middle = 0.5 * (berth.face.a + berth.face.b);
    const Ground::Spot on = s_ground->spot(middle + -6.0 * berth.outward());
    EXPECT_NEAR(on.inland_m, 6.0, 2.0);
    EXPECT_TRUE(s_ground->works(on));
    EXPECT_NEAR(s_ground->height_m(middle, on, true), 1.9, 0.3);
    EXPECT_LT(s_ground->spot(middle + 6.0 * berth.outward()).inland_m, 0.0);
}

TEST_F(GalleLand, RumassalaIsAHillAndTheBeachIsNot) {
    const auto height = [&](const char* place) {
        const core::NorthEast p = s_world->area.findPlace(place)->position;
        return s_ground->height_m(p, s_ground->spot(p), false);
    };
    EXPECT_GT(height("rumassala_summit"), 50.0);
    EXPECT_LT(height("fort"), 20.0);
}

TEST_F(GalleLand, FitsTheBudgetOfTriangles) {
    std::size_t triangles = 0;
    for (const Solid& s : landMesh(s_world->area, *s_ground)) triangles += s.triangles();
    EXPECT_LT(triangles, 60'000u);
    EXPECT_GT(triangles, 10'000u);
    std::size_t built = 0;
    for (const Solid& s : buildings(s_world->area, *s_ground, figuresOf(Preset::Medium)))
        built += s.triangles();
    EXPECT_LT(built, 25'000u);
}

TEST_F(GalleLand, TheLighthouseStandsAtItsPlaceWithItsLampAtTheHeightOfTheList) {
    const core::Mark& light = s_world->area.marks.front();
    ASSERT_EQ(light.kind, core::MarkKind::Lighthouse);
    double top = 0.0;
    for (const Solid& s : buildings(s_world->area, *s_ground, figuresOf(Preset::Low))) {
        for (const SolidVertex& v : s.vertices) {
            if (core::distance({v.position.x, v.position.y}, light.position) < 2.0)
                top = std::max(top, v.position.up);
        }
    }
    EXPECT_NEAR(top, light.light->height_m + 3.0, 0.1);
}

}  // namespace
}  // namespace sagara::render
