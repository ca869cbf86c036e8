#include "render/scene/Stage.h"

#include <gtest/gtest.h>

#include "core/exercise/Snapshot.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::render {
namespace {

constexpr int kWidth = 160, kHeight = 90;

/// One stage for all tests: starting it is what takes the time.
class StagePicture : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        unsetenv("DISPLAY");
        s_world = test::lessonWorld();
        auto stage = Stage::open({SAGARA_ASSETS, Preset::Low, true});
        ASSERT_TRUE(stage) << stage.error();
        s_stage = std::move(stage).value();
        const auto trouble = s_stage->show(s_world);
        ASSERT_FALSE(trouble) << *trouble;
    }
    static void TearDownTestSuite() { s_stage.reset(); }

    static Moment moment() { return momentOf(core::view(*s_world, core::startState(*s_world, 3))); }
    /// From the anchorage to the south, open sea.
    static Camera seaward() {
        Camera c;
        c.position = {-1500.0, 0.0};
        c.heading_rad = 3.1;
        c.lens = Lens::symmetric(1.0, kWidth, kHeight);
        return c;
    }
    static std::shared_ptr<const Picture> picture(const Camera& camera, int width = kWidth,
                                                  int height = kHeight) {
        const auto view = s_stage->addViewport(width, height);
        view->setCamera(camera);
        const auto trouble = s_stage->draw(moment());
        EXPECT_FALSE(trouble) << *trouble;
        return view->latest();
    }
    static inline std::shared_ptr<const core::World> s_world;
    static inline std::unique_ptr<Stage> s_stage;
};

TEST_F(StagePicture, NeedsNoXServer) {
    const auto p = picture(seaward());
    ASSERT_TRUE(p);
    EXPECT_EQ(p->width, kWidth);
    EXPECT_EQ(p->bgra.size(), 4u * kWidth * kHeight);
}

TEST_F(StagePicture, HasSkyAboveAndSeaBelow) {
    const auto p = picture(seaward());
    const auto brightness = [&](int y) {
        const std::uint8_t* c = p->pixel(kWidth / 2, y);
        return c[0] + c[1] + c[2];
    };
    EXPECT_GT(brightness(kHeight / 4), brightness(3 * kHeight / 4) + 100);
    const std::uint8_t* sky = p->pixel(kWidth / 2, 2);
    EXPECT_GT(sky[0], sky[2]) << "the sky is blue";
}

TEST_F(StagePicture, IsTheSameToTheBitWhenDrawnAgain) {
    EXPECT_EQ(picture(seaward())->bgra, picture(seaward())->bgra);
}

TEST_F(StagePicture, FollowsTheSizeOfItsViewport) {
    const auto view = s_stage->addViewport(kWidth, kHeight);
    view->setCamera(seaward());
    for (const int width : {64, 200, 33}) {
        view->resize(width, 40);
        ASSERT_FALSE(s_stage->draw(moment()));
        EXPECT_EQ(view->latest()->width, width);
    }
}

TEST_F(StagePicture, ShowsAnotherExerciseAfterTheFirst) {
    const auto before = picture(seaward());
    ASSERT_FALSE(s_stage->show(s_world));
    EXPECT_EQ(picture(seaward())->bgra, before->bgra);
}

TEST_F(StagePicture, DrawsSoonWithoutWaiting) {
    const auto view = s_stage->addViewport(32, 32);
    view->setCamera(seaward());
    for (int i = 0; i < 20; ++i) s_stage->drawSoon(moment());
    ASSERT_FALSE(s_stage->draw(moment()));  // comes after them
    EXPECT_EQ(view->latest()->width, 32);
}

}  // namespace
}  // namespace sagara::render
