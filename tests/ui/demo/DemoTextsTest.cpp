#include "ui/demo/DemoTexts.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "core/exercise/Session.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::ui {
namespace {

std::string std8(const QString& text) { return text.toStdString(); }

TEST(DemoTexts, TellWhatThePilotDoes) {
    const auto world = test::lessonWorld();
    core::State state = core::startState(*world, 3);
    EXPECT_EQ(std8(demoHappening(*world, state, {})), "The lines are let go");
    state = core::sailedByPilot(world, 3, core::SimTime{400'000'000});
    const core::Snapshot now = core::view(*world, state);
    const Hints hints = hintsFor(*world, now, state.assessment.route);
    const DemoCaption caption = demoCaption(*world, state, now, hints);
    ASSERT_TRUE(hints.waypoint);
    EXPECT_EQ(std8(caption.title), "On the way to “" + hints.waypoint->name + "”");
    ASSERT_EQ(caption.figures.size(), 5);
    EXPECT_EQ(std8(caption.figures[0].name), "Speed");
    EXPECT_TRUE(caption.figures[0].value.endsWith(QStringLiteral(" kn")));
    EXPECT_EQ(std8(caption.figures[3].value), "Beaufort 3 from north-east");
}

TEST(DemoTexts, NameTheQuartersOfTheWind) {
    EXPECT_EQ(std8(demoCompass(0.0)), "north");
    EXPECT_EQ(std8(demoCompass(355.0 * core::kDegree_rad)), "north");
    EXPECT_EQ(std8(demoCompass(235.0 * core::kDegree_rad)), "south-west");
}

TEST(DemoTexts, NameRudderAndEngine) {
    EXPECT_EQ(std8(demoRudder(-10.0 * core::kDegree_rad)), "Port 10°");
    EXPECT_EQ(std8(demoRudder(0.0)), "Midships");
    EXPECT_EQ(std8(demoEngine(core::TelegraphStep::HalfAhead)), "Half ahead");
}

TEST(DemoCameras, GoRoundAndLeaveOutWhatShowsNothing) {
    const auto world = test::lessonWorld();
    render::Moment moment = render::momentOf(core::view(*world, core::startState(*world, 3)));
    ASSERT_TRUE(shoreFor(*world, moment));
    DemoCamera camera{DemoCameraKind::Bridge};
    std::vector<DemoCameraKind> seen;
    for (int i = 0; i < 10; ++i) seen.push_back((camera = nextDemoCamera(camera, *world, moment)).kind);
    using K = DemoCameraKind;
    for (const K kind : {K::Bridge, K::Chase, K::Shore, K::Wing, K::Target})
        EXPECT_EQ(std::count(seen.begin(), seen.end(), kind), 2) << static_cast<int>(kind);
    // Alone far out nothing but her own cameras is left.
    moment.targets.clear();
    moment.ships[0].position = {-20'000.0, 0.0};
    seen.clear();
    for (int i = 0; i < 6; ++i) seen.push_back((camera = nextDemoCamera(camera, *world, moment)).kind);
    EXPECT_EQ(std::count(seen.begin(), seen.end(), K::Shore), 0);
    EXPECT_EQ(std::count(seen.begin(), seen.end(), K::Target), 0);
    EXPECT_EQ(std::count(seen.begin(), seen.end(), K::Bridge), 2);
}

TEST(DemoCameras, ACameraWhoseShipHasGoneShowsHerFromAstern) {
    const auto world = test::lessonWorld();
    const render::Moment moment = render::momentOf(core::view(*world, core::startState(*world, 3)));
    CameraRig rig;
    aim(rig, {DemoCameraKind::Target, 999}, *world, moment);
    EXPECT_EQ(rig.kind, CameraKind::Chase);
}

}  // namespace
}  // namespace sagara::ui
