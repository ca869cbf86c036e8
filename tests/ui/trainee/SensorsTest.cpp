// Screens of radar and sounder, alarms and the printed chart: what needs no whole console.
#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QTest>

#include "SteppedRun.h"
#include "tests/support/exercise/Lesson.h"
#include "ui/trainee/RadarPage.h"
#include "ui/trainee/ShipAlarms.h"
#include "ui/trainee/ShipReadings.h"
#include "ui/trainee/SounderView.h"

namespace sagara::ui::console {
namespace {

using core::kDegree_rad;

TEST(ShipsAlarms, ComeOnceSoundUntilAcknowledgedAndStayWhileTheirCauseLasts) {
    ShipAlarms alarms;
    AlarmInputs in;
    in.underKeel_m = 1.0;
    in.depthAlarm_m = 2.0;
    alarms.update(in);
    alarms.update(in);
    ASSERT_EQ(alarms.list().size(), 1u);
    EXPECT_TRUE(alarms.sounding());
    alarms.acknowledgeAll();
    EXPECT_FALSE(alarms.sounding());
    alarms.update(in);
    EXPECT_EQ(alarms.list().size(), 1u);
    in.underKeel_m = 3.0;
    alarms.update(in);
    EXPECT_TRUE(alarms.list().empty());
    in.underKeel_m = 1.0;
    alarms.update(in);
    EXPECT_TRUE(alarms.sounding()) << "it comes again";
    in.underKeel_m = 3.0;
    alarms.update(in);
    ASSERT_EQ(alarms.list().size(), 1u) << "passed, but nobody has seen it";
    EXPECT_FALSE(alarms.list()[0].active);
    alarms.acknowledgeAll();
    EXPECT_TRUE(alarms.list().empty());
}

TEST(ShipsAlarms, OffCourseNeedsFiveSeconds) {
    ShipAlarms alarms;
    AlarmInputs in;
    in.offCourse_rad = -12.0 * kDegree_rad;
    for (in.time_s = 0.0; in.time_s < 4.9; in.time_s += 0.2) alarms.update(in);
    EXPECT_TRUE(alarms.list().empty());
    in.time_s = 5.1;
    alarms.update(in);
    EXPECT_EQ(alarms.list().size(), 1u);
    ShipAlarms other;
    in.offCourse_rad = 8.0 * kDegree_rad;
    for (in.time_s = 0.0; in.time_s < 20.0; in.time_s += 0.2) other.update(in);
    EXPECT_TRUE(other.list().empty());
}

TEST(SoundersTrace, KeepsTenMinutesAndChoosesItsScale) {
    SounderTrace trace;
    for (int s = 0; s <= 900; ++s) {
        trace.add(s, s < 650 ? 30.0 : 8.0);
        trace.add(s + 0.2, 1.0);  // within the same second: left out
    }
    EXPECT_EQ(trace.soundings().front().time_s, 300.0);
    EXPECT_EQ(trace.soundings().size(), 601u);
    EXPECT_EQ(trace.scale_m(600.0), 50.0);
    EXPECT_EQ(trace.scale_m(120.0), 10.0);
    trace.add(10.0, 4.0);  // gone back to a snapshot
    EXPECT_EQ(trace.soundings().size(), 1u);
}

TEST(Readings, RelativeWindIsTheTrueOneLessTheWayOfTheShip) {
    const auto world = test::lessonWorld();
    core::Snapshot now = core::view(*world, core::startState(*world, 3));
    core::OwnShipView& own = now.ships[0];
    own.motion.heading_rad = 0.0;
    own.overGround_mps = {5.0, 0.0};
    now.wind = {5.0, 90.0 * kDegree_rad};  // from the east, as strong as she is fast
    const auto r = readingsOf(*world, now, 0, core::sounderOf(world->ships[0]->vessel));
    EXPECT_NEAR(r.relative_mps, 5.0 * std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(r.relativeFrom_rad, 45.0 * kDegree_rad, 1e-9);
    EXPECT_NEAR(*r.course_rad, r.heading_rad, 1e-9);
    EXPECT_NEAR(*r.underKeel_m, own.underKeel_m, 1.5) << "at the transducer, not where it is least";
}

class RadarOfTheLesson : public ::testing::Test {
protected:
    test::SteppedRun m_run{test::lessonWorld()};
    RadarPage m_page{*m_run.world(), 0};
    void SetUp() override {
        m_page.resize(900, 700);
        m_page.show();
        m_page.advance({}, *m_run.latest());
        QApplication::processEvents();
    }
};

TEST_F(RadarOfTheLesson, ScreenAndGroundAgreeInEveryOrientation) {
    RadarView& view = m_page.view();
    const core::ShipMotion& m = m_run.latest()->ships[0].motion;
    const double middle = view.width() / 2.0;
    view.setUp(RadarView::Up::Head);
    EXPECT_NEAR(view.placeOf({m.heading_rad, 1000.0}).x(), middle, 0.6);
    EXPECT_LT(view.placeOf({m.heading_rad, 1000.0}).y(), view.height() / 2.0);
    view.setUp(RadarView::Up::North);
    EXPECT_NEAR(view.placeOf({0.0, 1000.0}).x(), middle, 1.0);
    const auto back = view.polarAt(view.placeOf({1.0, 1234.0}));
    EXPECT_NEAR(back.bearing_rad, 1.0, 1e-9);
    EXPECT_NEAR(back.range_m, 1234.0, 1e-6);
}

TEST_F(RadarOfTheLesson, BearingLineAndRangeMarkerGoWhereTheyAreDragged) {
    RadarView& view = m_page.view();
    view.setBearingLine(0.0);
    view.setRangeMarker(500.0);
    const RadarView::Polar to{1.2, 1500.0};
    QTest::mouseClick(&view, Qt::LeftButton, {}, view.placeOf(to).toPoint());
    EXPECT_NEAR(*view.bearingLine(), 1.2, 0.01);
    EXPECT_NEAR(*view.rangeMarker(), 1500.0, 10.0);
}

TEST_F(RadarOfTheLesson, TheAntennaTurnsInTwoAndAHalfSecondsOfTheExercise) {
    RadarScanner scanner(*m_run.world(), 0);
    scanner.advance({}, *m_run.latest());
    EXPECT_EQ(scanner.azimuth(), 0u);
    scanner.advance({625'000}, *m_run.latest());
    EXPECT_EQ(scanner.azimuth(), core::RadarPicture::kAzimuths / 4);
    scanner.advance({2'500'000}, *m_run.latest());
    EXPECT_EQ(scanner.azimuth(), 0u);
}

TEST_F(RadarOfTheLesson, APictureCostsLittle) {
    RadarView& view = m_page.view();
    QPixmap target(view.size());
    view.render(&target);  // tables are made
    QElapsedTimer clock;
    clock.start();
    for (int i = 0; i < 20; ++i) view.render(&target);
    const double paint_ms = static_cast<double>(clock.nsecsElapsed()) * 1e-6 / 20.0;
    clock.restart();
    for (int i = 1; i <= 50; ++i) m_page.advance({i * 50'000}, *m_run.latest());
    const double sweep_ms = static_cast<double>(clock.nsecsElapsed()) * 1e-6 / 50.0;
    RecordProperty("paint_us", static_cast<int>(1000.0 * paint_ms));
    std::printf("radar: paint %.2f ms at %d px, sweep of a frame %.2f ms\n", paint_ms, view.height(),
                sweep_ms);
    EXPECT_LT(paint_ms, 50.0) << "10 ms on an idle machine";
    EXPECT_LT(sweep_ms, 50.0);
}

}  // namespace
}  // namespace sagara::ui::console
