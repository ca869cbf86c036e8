// Windows of a channel on an X server (Xvfb): what they show, and what people and window systems do to them.
#include <gtest/gtest.h>

#include "XServer.h"
#include "core/exercise/Snapshot.h"
#include "render/scene/Stage.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::render {
namespace {

class Windows : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        s_x = std::make_unique<test::XServer>();
        s_x->splitInTwo();
        s_world = test::lessonWorld();
        auto stage = Stage::open({SAGARA_ASSETS, Preset::Low, false});
        ASSERT_TRUE(stage) << stage.error();
        s_stage = std::move(stage).value();
        const auto trouble = s_stage->show(s_world);
        ASSERT_FALSE(trouble) << *trouble;
    }
    static void TearDownTestSuite() {
        s_stage.reset();
        s_x.reset();
    }

    static std::shared_ptr<Viewport> open(const WindowOptions& options) {
        auto window = s_stage->addWindow(options);
        EXPECT_TRUE(window) << window.error();
        return window ? std::move(window).value() : nullptr;
    }
    static void draw(Viewport& view) {
        Camera c;
        c.position = {-1500.0, 0.0};
        c.heading_rad = 3.1;
        c.lens = Lens::symmetric(1.0, 320, 180);
        view.setCamera(c);
        const auto trouble = s_stage->draw(momentOf(core::view(*s_world, core::startState(*s_world, 3))));
        EXPECT_FALSE(trouble) << *trouble;
        s_stage->present();
    }

    static inline std::unique_ptr<test::XServer> s_x;
    static inline std::shared_ptr<const core::World> s_world;
    static inline std::unique_ptr<Stage> s_stage;
};

TEST_F(Windows, ShowThePictureThatIsReadBack) {
    const auto view = open({.title = "shown", .width = 320, .height = 180, .readBack = true});
    draw(*view);
    const Window window = s_x->find("shown");
    ASSERT_NE(window, 0u);
    const auto picture = view->latest();
    ASSERT_TRUE(picture);
    const auto pixels = s_x->pixels(window);
    ASSERT_EQ(pixels.size(), 3u * 320 * 180);
    std::size_t other = 0;
    for (std::size_t i = 0; i < 320 * 180; ++i) {
        for (std::size_t c = 0; c < 3; ++c) other += pixels[3 * i + c] != picture->bgra[4 * i + c];
    }
    EXPECT_EQ(other, 0u);
}

TEST_F(Windows, FollowTheSizePeopleGiveThem) {
    const auto view = open({.title = "sized", .width = 320, .height = 180, .readBack = true});
    draw(*view);
    s_x->resize(s_x->find("sized"), 400, 300);
    draw(*view);
    draw(*view);
    EXPECT_EQ(view->size().width, 400);
    EXPECT_EQ(view->size().height, 300);
    EXPECT_EQ(view->latest()->width, 400);
}

TEST_F(Windows, SayThatTheyHaveBeenClosed) {
    const auto view = open({.title = "closed", .width = 320, .height = 180});
    draw(*view);
    EXPECT_FALSE(view->closed());
    s_x->askToClose(s_x->find("closed"));
    draw(*view);
    EXPECT_TRUE(view->closed());
}

TEST_F(Windows, CoverTheScreenTheyAreToldTo) {
    const int half = s_x->screenWidth() / 2, height = s_x->screenHeight();
    for (const int screen : {0, 1}) {
        const std::string title = "screen " + std::to_string(screen);
        const auto view =
            open({.title = title, .width = 320, .height = 180, .fullScreen = true, .screen = screen});
        draw(*view);
        EXPECT_EQ(s_x->geometry(s_x->find(title)), (test::XServer::Geometry{screen * half, 0, half, height}));
        EXPECT_EQ(view->size().width, half);
    }
}

TEST_F(Windows, OpenOnTheScreenTheyAreToldTo) {
    const auto view = open({.title = "right", .width = 320, .height = 180, .screen = 1});
    draw(*view);
    const auto g = s_x->geometry(s_x->find("right"));
    EXPECT_EQ(g.left, s_x->screenWidth() * 3 / 4 - 160);
    EXPECT_EQ(g.width, 320);
}

TEST_F(Windows, AScreenThatIsNotThereIsAMessage) {
    const auto window = s_stage->addWindow({.width = 320, .height = 180, .fullScreen = true, .screen = 2});
    ASSERT_FALSE(window);
    EXPECT_EQ(window.error(), "there is no screen 2; this display has 2, counted from 0, left to right");
}

TEST_F(Windows, TexturesShowTheSameSceneBesideThem) {
    const auto window = open({.title = "beside", .width = 320, .height = 180, .readBack = true});
    const auto texture = s_stage->addViewport(320, 180);
    Camera c;
    c.lens = Lens::symmetric(1.0, 320, 180);
    texture->setCamera(c);
    window->setCamera(c);
    ASSERT_FALSE(s_stage->draw(momentOf(core::view(*s_world, core::startState(*s_world, 3)))));
    const auto& a = window->latest()->bgra;
    const auto& b = texture->latest()->bgra;
    ASSERT_EQ(a.size(), b.size());
    std::size_t other = 0;
    for (std::size_t i = 0; i < a.size(); ++i) other += i % 4 != 3 && a[i] != b[i];
    // Textures are drawn upside down: a few pixels on edges round the other way.
    EXPECT_LT(other, a.size() / 1000);
}

}  // namespace
}  // namespace sagara::render
