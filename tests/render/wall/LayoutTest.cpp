#include "render/wall/Layout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/base/Angle.h"
#include "tests/support/Assets.h"

namespace sagara::wall {
namespace {

Layout shipped(const std::string& id) {
    auto layout = loadLayout(id + ".json", test::readAsset("walls/" + id + ".json"));
    EXPECT_TRUE(layout) << layout.error().text();
    return layout ? std::move(layout).value() : Layout{};
}
std::string problemsOf(const std::string& text) {
    const auto layout = loadLayout("w.json", text);
    return layout ? "" : layout.error().text();
}
std::string wallOf(const std::string& channels) {
    return R"({"document": "wall", "version": 1, "id": "w", "name": "W", "channels": [)" + channels + "]}";
}
double leftEdge_deg(const link::ChannelView& v) {
    return (v.yaw_rad - std::atan(v.frustum.left)) / core::kDegree_rad;
}
double rightEdge_deg(const link::ChannelView& v) {
    return (v.yaw_rad + std::atan(v.frustum.right)) / core::kDegree_rad;
}

TEST(Layout, EveryShippedWallLoadsUnderItsName) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(SAGARA_ASSETS "/walls")) {
        if (entry.path().extension() != ".json") continue;
        EXPECT_EQ(shipped(entry.path().stem().string()).id, entry.path().stem().string());
        ++count;
    }
    EXPECT_GE(count, 4);
}

struct Wall {
    const char* id;
    std::size_t channels;
    double from_deg, to_deg;
};
class ShippedWall : public ::testing::TestWithParam<Wall> {};
TEST_P(ShippedWall, ChannelsMeetEdgeToEdge) {
    const Layout layout = shipped(GetParam().id);
    ASSERT_EQ(layout.channels.size(), GetParam().channels);
    EXPECT_NEAR(leftEdge_deg(layout.channels.front().view), GetParam().from_deg, 1e-9);
    EXPECT_NEAR(rightEdge_deg(layout.channels.back().view), GetParam().to_deg, 1e-9);
    for (std::size_t i = 1; i < layout.channels.size(); ++i)
        EXPECT_NEAR(rightEdge_deg(layout.channels[i - 1].view), leftEdge_deg(layout.channels[i].view), 1e-9);
}
INSTANTIATE_TEST_SUITE_P(Shipped, ShippedWall,
                         ::testing::Values(Wall{"single", 1, -30, 30}, Wall{"desk-3x60", 3, -90, 90},
                                           Wall{"paper-5x54", 5, -135, 135}, Wall{"ring-6x60", 6, -150, 210}),
                         [](const auto& row) {
                             std::string name = row.param.id;
                             name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                             return name;
                         });

TEST(Layout, TheDeskLooksToPortAheadAndToStarboard) {
    const Layout desk = shipped("desk-3x60");
    EXPECT_NEAR(desk.channels[0].view.yaw_rad, -core::kPi / 3.0, 1e-12);
    EXPECT_EQ(desk.channels[1].view.yaw_rad, 0.0);
    EXPECT_NEAR(desk.channels[2].view.yaw_rad, core::kPi / 3.0, 1e-12);
    EXPECT_NEAR(desk.channels[1].view.frustum.up, std::tan(core::kPi / 6.0) * 9.0 / 16.0, 1e-12);
    EXPECT_TRUE(desk.channels[0].local());
}

TEST(Layout, OffAxisEdgesAndHorizonAreRead) {
    const auto wall = loadLayout(
        "w.json",
        wallOf(
            R"({"name": "a", "yaw_deg": 0, "edges_deg": {"left": 45, "right": 0, "down": 26.565051, "up": 0},
                   "size_px": [800, 400], "host": "pc2", "output": "fullscreen", "screen": 2, "ship": 1,
                   "eye": {"starboard_m": -4.5}},
                  {"name": "b", "yaw_deg": 10, "fieldOfView_deg": 90, "horizonAt": 0.75, "size_px": [800, 400]})"));
    ASSERT_TRUE(wall) << wall.error().text();
    const link::ChannelView& a = wall->channels[0].view;
    EXPECT_NEAR(a.frustum.left, 1.0, 1e-12);
    EXPECT_EQ(a.frustum.right, 0.0);
    EXPECT_NEAR(a.frustum.down, 0.5, 1e-6);
    EXPECT_EQ(a.output, link::Output::Fullscreen);
    EXPECT_EQ(a.screen, 2u);
    EXPECT_EQ(a.ship, 1u);
    EXPECT_EQ(a.eye.starboard_m, -4.5);
    EXPECT_FALSE(wall->channels[0].local());
    const link::ChannelView& b = wall->channels[1].view;
    EXPECT_NEAR(b.frustum.down, 0.75, 1e-12);
    EXPECT_NEAR(b.frustum.up, 0.25, 1e-12);
}

TEST(Layout, FullScreenChannelsOfThisPcTakeItsScreensFromLeftToRight) {
    Layout desk = shipped("desk-3x60");
    desk.channels[1].host = "pc2";
    desk = fullScreen(desk);
    for (const LayoutChannel& channel : desk.channels)
        EXPECT_EQ(channel.view.output, link::Output::Fullscreen);
    EXPECT_EQ(desk.channels[0].view.screen, 0u);
    EXPECT_EQ(desk.channels[1].view.screen, 0u);
    EXPECT_EQ(desk.channels[2].view.screen, 1u);
}

TEST(Layout, EveryProblemIsReportedAtOnceWithItsPath) {
    EXPECT_EQ(
        problemsOf(wallOf(R"({"name": "a", "yaw_deg": 200, "fieldOfView_deg": 170, "size_px": [800, 400]},
                                   {"name": "a", "yaw_deg": 0, "fieldOfView_deg": 60, "size_px": [8000, 400],
                                    "fov": 3})")),
        "w.json: channels[0].yaw_deg is 200, expected -180 to 180 deg\n"
        "w.json: channels[0].fieldOfView_deg is 170, expected 5 to 150 deg\n"
        "w.json: channels[1].size_px[0] is 8000, expected 64 to 4096 pixels\n"
        "w.json: channels[1].fov is unknown, expected one of fieldOfView_deg, horizonAt, host, name, screen, "
        "ship, size_px, yaw_deg\n"
        "w.json: channels[1] has the name \"a\" of another, expected a name of its own");
}

TEST(Layout, ImpossibleFrustaAreRefused) {
    const auto edges = [](const std::string& deg) {
        return problemsOf(
            wallOf(R"({"name": "a", "yaw_deg": 0, "size_px": [800, 400], "edges_deg": )" + deg + "}"));
    };
    EXPECT_EQ(
        edges(R"({"left": -30, "right": 30, "down": 20, "up": 20})"),
        "w.json: channels[0].edges_deg leaves nothing to see, expected left + right and down + up of 3 deg "
        "or more");
    EXPECT_EQ(
        edges(R"({"left": 45, "right": 45, "down": 45, "up": 45})"),
        "w.json: channels[0].edges_deg gives pixels 0.5 times as wide as high, expected square ones, within "
        "5 %");
    EXPECT_EQ(problemsOf(wallOf("")), "w.json: channels has 0, expected 1 to 16");
}

TEST(Layout, AnotherSizeKeepsTheWidthOfTheFieldOfView) {
    const Layout wall = resized(shipped("desk-3x60"), 400, 400);
    const link::Frustum& f = wall.channels[1].view.frustum;
    EXPECT_NEAR(f.left, std::tan(core::kPi / 6.0), 1e-12);
    EXPECT_NEAR(f.up, f.left, 1e-12);
    EXPECT_EQ(wall.channels[2].view.height_px, 400u);
}

}  // namespace
}  // namespace sagara::wall
