#include "render/scene/Stage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

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

/// Mean difference of two pictures, of 255.
double difference(const Picture& a, const Picture& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.bgra.size(); ++i) sum += std::abs(a.bgra[i] - b.bgra[i]);
    return sum / static_cast<double>(a.bgra.size());
}

TEST_F(StagePicture, DoesNotPopOrSwimWhenTheEyeMoves) {
    // The world stands still, the eye glides. Each step changes the picture a little and all steps about
    // alike: a net that jumped or waves that swam along with it would show as a step that stands out.
    std::vector<double> steps;
    std::shared_ptr<const Picture> last;
    for (int i = 0; i < 40; ++i) {
        Camera c = seaward();
        c.position.north_m -= 0.05 * i;
        c.position.east_m += 0.02 * i;
        const auto now = picture(c);
        if (last) steps.push_back(difference(*last, *now));
        last = now;
    }
    std::sort(steps.begin(), steps.end());
    const double middle = steps[steps.size() / 2];
    EXPECT_LT(middle, 2.0);
    EXPECT_LT(steps.back(), 2.0 * middle);
}

TEST_F(StagePicture, GoesOnAcrossTheEdgeOfATile) {
    // 25, 160 and 1200 m tiles all end at 0; a step over it must look like any other.
    const auto step = [&](double from_m) {
        Camera a = seaward(), b = seaward();
        a.position = {-2400.0 + from_m, 1200.0 + from_m};
        b.position = {-2400.0 + from_m + 0.05, 1200.0 + from_m + 0.05};
        return difference(*picture(a), *picture(b));
    };
    EXPECT_LT(step(-0.025), 1.6 * step(-3.0));
}

TEST_F(StagePicture, ShowsALightOnlyWhileItIsLit) {
    const core::Mark& light = s_world->area.marks.front();
    Camera c = shoreCamera(light.position + core::NorthEast{-600.0, 500.0}, 10.0, light.position,
                           light.light->height_m, Lens::symmetric(0.1, kWidth, kHeight));
    const auto brightest = [&](double seconds) {
        Moment m = moment();
        // 13.5 h after the lesson's start it is 22:30 in Galle.
        m.time.us = static_cast<std::int64_t>((13.5 * 3600.0 + seconds) * 1e6);
        const auto view = s_stage->addViewport(kWidth, kHeight);
        view->setCamera(c);
        EXPECT_FALSE(s_stage->draw(m));
        int most = 0;
        for (int y = kHeight / 2 - 6; y < kHeight / 2 + 6; ++y)
            for (int x = kWidth / 2 - 6; x < kWidth / 2 + 6; ++x)
                most = std::max(most, static_cast<int>(view->latest()->pixel(x, y)[1]));
        return most;
    };
    const double period_s = 15.0;  // 13.5 h are whole periods
    EXPECT_GT(brightest(0.2), brightest(1.0) + 15);
    EXPECT_GT(brightest(2.2), brightest(5.0) + 15);
    EXPECT_GT(brightest(period_s + 0.2), brightest(period_s - 1.0) + 15);
}

TEST_F(StagePicture, LinesAndShapesComeAndGoWithoutATrace) {
    const auto drawn = [&](core::Activity activity, bool onLines) {
        Moment m = moment();
        OwnShipPose& own = m.ships[0];
        own.activity = activity;
        if (!onLines) own.lines.clear();
        const core::HeadingFrame deck(own.position, own.heading_rad);
        const auto view = s_stage->addViewport(kWidth, kHeight);
        view->setCamera(shoreCamera(deck.point({50.0, -16.0}), 7.0, deck.point({16.0, 0.0}), 3.0,
                                    Lens::symmetric(1.0, kWidth, kHeight)));
        EXPECT_FALSE(s_stage->draw(m));
        return view->latest()->bgra;
    };
    const auto moored = drawn(core::Activity::Moored, true), bare = drawn(core::Activity::Moored, false),
               anchored = drawn(core::Activity::Anchored, false);
    EXPECT_NE(moored, bare) << "no line is seen";
    EXPECT_NE(anchored, bare) << "no ball is seen";
    EXPECT_EQ(drawn(core::Activity::Moored, true), moored);
    EXPECT_EQ(drawn(core::Activity::Moored, false), bare);
}

TEST(Stage, TellsWhatIsMissingWhenThereIsNoDisplay) {
    unsetenv("DISPLAY");
    const auto stage = Stage::open({SAGARA_ASSETS, Preset::Low, false});
    ASSERT_FALSE(stage);
    EXPECT_EQ(stage.error(),
              "There is no X display (DISPLAY is not set): start it in a desktop, or without a window.");
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

TEST_F(StagePicture, DrawsAModelWithItsTextureAlikeInEveryScene) {
    EXPECT_TRUE(s_stage->remarks().empty()) << s_stage->remarks().front();
    const Moment m = moment();
    const auto yacht = std::find_if(m.targets.begin(), m.targets.end(), [](const TargetPose& t) {
        return s_world->targets[t.index].picture == "yacht";
    });
    ASSERT_NE(yacht, m.targets.end());
    // The white topsides are of the texture; her blue boot-topping is on the same part of it.
    const Camera beside = shoreCamera(yacht->position + core::NorthEast{-12.0, -12.0}, 3.0, yacht->position,
                                      1.0, Lens::symmetric(0.6, kWidth, kHeight));
    const auto first = picture(beside);
    int white = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const std::uint8_t* c = first->pixel(x, y);
            if (c[0] > 150 && std::abs(c[0] - c[2]) < 30 && y > kHeight / 2) ++white;
        }
    }
    EXPECT_GT(white, 200);
    ASSERT_FALSE(s_stage->show(s_world));
    EXPECT_EQ(picture(beside)->bgra, first->bgra);
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
