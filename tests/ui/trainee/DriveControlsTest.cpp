// Pitch levers and azimuth dials of the trainee's console, worked as a trainee would.
#include <gtest/gtest.h>

#include <QApplication>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <cstdlib>

#include "SteppedRun.h"
#include "core/base/Angle.h"
#include "tests/support/exercise/Lesson.h"
#include "ui/theme/Theme.h"
#include "ui/trainee/AzimuthDial.h"
#include "ui/trainee/HelmWheel.h"
#include "ui/trainee/PitchLever.h"
#include "ui/trainee/ShaftTelegraph.h"
#include "ui/trainee/TraineeConsole.h"

namespace sagara::ui {
namespace {

using console::AzimuthDial;
using console::PitchLever;
using console::ShaftTelegraph;
using core::kDegree_rad;

std::shared_ptr<const core::World> worldWith(const char* vessel) {
    const QString json = QStringLiteral("\"%1\"").arg(QLatin1String(vessel));
    return test::worldOf(test::with(test::openWaterScenario(1, 0), "/ownShips/0/vessel", json.toStdString()));
}

/// A console without briefing and scene, of a vessel in open water.
class Bridge {
public:
    explicit Bridge(const char* vessel) : run(worldWith(vessel)) {
        ConsoleOptions options;
        options.briefing = false;
        console = std::make_unique<TraineeConsole>(run, nullptr, options);
        console->resize(1280, 720);
        console->show();
        run.start();
        console->refresh();
        QApplication::processEvents();
    }
    /// Longer than an order may be on its way, for whoever follows others.
    void settle() {
        sail(0.1);
        QTest::qWait(450);
        console->refresh();
    }
    void sail(double seconds) {
        run.sail(seconds);
        console->refresh();
    }
    template <typename Widget>
    Widget* find(const char* name) {
        return console->findChild<Widget*>(QString::fromLatin1(name));
    }
    const core::DriveView& drive(std::size_t i) const { return run.latest()->ships[0].drives[i]; }

    test::SteppedRun run;
    std::unique_ptr<TraineeConsole> console;
};

void turnWheel(QWidget* widget, int steps) {
    const QPointF at(widget->width() / 2.0, widget->height() / 2.0);
    QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, 120 * steps}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
}

TEST(DriveControls, AreThereOnlyWhereThePropellersHaveThem) {
    Bridge patrol("patrol51"), ferry("ferry86"), tug("tug30"), trawler("trawler27");
    for (const char* name : {"pitch-0", "azimuth-0"})
        EXPECT_EQ(patrol.find<QWidget>(name), nullptr) << "fixed blades, shafts";
    EXPECT_NE(ferry.find<PitchLever>("pitch-1"), nullptr);
    EXPECT_EQ(ferry.find<QWidget>("azimuth-0"), nullptr);
    EXPECT_NE(tug.find<AzimuthDial>("azimuth-1"), nullptr);
    EXPECT_EQ(tug.find<QWidget>("pitch-0"), nullptr);
    EXPECT_NE(trawler.find<PitchLever>("pitch-0"), nullptr);
    EXPECT_EQ(trawler.find<QWidget>("pitch-1"), nullptr) << "one shaft";
}

TEST(PitchLever, OrdersThePitchOfItsShaftAndShowsWhatItIs) {
    Bridge ferry("ferry86");
    ferry.console->setTelegraph(0, core::TelegraphStep::HalfAhead);
    ferry.console->setTelegraph(1, core::TelegraphStep::HalfAhead);
    ferry.sail(60.0);
    ASSERT_NEAR(ferry.drive(0).pitch, 1.0, 1e-9) << "half ahead is more than the slowest revolutions";
    auto* const lever = ferry.find<PitchLever>("pitch-0");
    QTest::mouseClick(lever, Qt::LeftButton, {}, QPoint(lever->width() / 3, lever->height() - 4));
    ferry.sail(0.1);
    EXPECT_NEAR(ferry.drive(0).pitchOrder, -0.85, 1e-9) << "at the bottom: as far astern as the blades turn";
    EXPECT_TRUE(ferry.drive(0).pitchByHand);
    EXPECT_FALSE(ferry.drive(1).pitchByHand) << "the other shaft goes on";
    EXPECT_GT(ferry.drive(0).pitch, 0.9) << "blades take their time";
    ferry.sail(60.0);
    EXPECT_NEAR(ferry.drive(0).pitch, -0.85, 1e-9);
    EXPECT_GT(ferry.run.latest()->ships[0].shafts_rps[0], 0.0) << "the shaft turns as it did";
    turnWheel(lever, 2);
    QTest::keyClick(lever, Qt::Key_Up);
    ferry.sail(0.1);
    EXPECT_NEAR(ferry.drive(0).pitchOrder, -0.70, 1e-9) << "three steps of 5 %";
}

TEST(PitchLever, HoldsUntilTheNextOrderOfTheTelegraph) {
    Bridge ferry("ferry86");
    ferry.console->setTelegraph(0, core::TelegraphStep::Stop);
    ferry.settle();
    auto* const lever = ferry.find<PitchLever>("pitch-0");
    auto* const telegraph = ferry.find<ShaftTelegraph>("telegraph-0");
    EXPECT_FALSE(lever->byHand());
    EXPECT_EQ(lever->order(), 0.0) << "follows the telegraph";
    lever->moveTo(0.3);
    ferry.settle();
    EXPECT_TRUE(lever->byHand());
    QTest::mouseClick(telegraph, Qt::LeftButton, {},
                      QPoint(telegraph->width() / 2, 555 * telegraph->height() / 1000));
    ASSERT_EQ(telegraph->step(), core::TelegraphStep::Stop);
    ferry.settle();
    EXPECT_FALSE(lever->byHand()) << "a click on the step it had";
    EXPECT_EQ(ferry.drive(0).pitchOrder, 0.0);
    lever->moveTo(0.3);
    ferry.settle();
    QTest::mouseDClick(lever, Qt::LeftButton);
    ferry.settle();
    EXPECT_FALSE(lever->byHand()) << "a double click gives it back";
}

TEST(PitchLever, FollowsDevicesWithinItsLimits) {
    Bridge ferry("ferry86");
    ferry.console->setPitch(1, -1.0);
    ferry.console->setPitch(7, 0.5);    // no such shaft: nothing
    ferry.console->setAzimuth(1, 1.0);  // no such drive: nothing
    ferry.console->shiftAzimuth(0, 1);
    ASSERT_EQ(ferry.run.given.size(), 1u);
    const auto* const order = ferry.run.last<core::PitchOrder>();
    ASSERT_NE(order, nullptr);
    EXPECT_EQ(order->shaft, 1);
    EXPECT_EQ(order->pitch, -0.85);
    EXPECT_EQ(ferry.find<PitchLever>("pitch-1")->order(), -0.85);
    ferry.console->shiftPitch(1, 2);
    EXPECT_NEAR(ferry.run.last<core::PitchOrder>()->pitch, -0.75, 1e-12);
}

TEST(AzimuthDial, TurnsItsDriveToWhereItIsDragged) {
    Bridge tug("tug30");
    auto* const dial = tug.find<AzimuthDial>("azimuth-0");
    const QPoint middle(dial->width() / 2, 44 * dial->height() / 100);
    QTest::mousePress(dial, Qt::LeftButton, {}, middle + QPoint(40, 0));
    tug.sail(0.1);
    EXPECT_NEAR(tug.drive(0).azimuthOrder_rad, 90.0 * kDegree_rad, 1e-9) << "to starboard";
    EXPECT_EQ(tug.drive(1).azimuthOrder_rad, 0.0) << "the other drive stays";
    QTest::mouseMove(dial, middle + QPoint(0, 40));
    QTest::mouseMove(dial, middle + QPoint(-40, 40));
    QTest::mouseRelease(dial, Qt::LeftButton, {}, middle + QPoint(-40, 40));
    tug.sail(0.1);
    EXPECT_NEAR(core::wrapTwoPi(tug.drive(0).azimuthOrder_rad), 225.0 * kDegree_rad, 1e-9) << "aft to port";
    EXPECT_LT(std::abs(tug.drive(0).azimuth_rad), 0.2) << "the drive takes its time";
    tug.sail(30.0);
    EXPECT_NEAR(core::wrapTwoPi(tug.drive(0).azimuth_rad), 225.0 * kDegree_rad, 1e-6);
    const std::size_t before = tug.run.given.size();
    QTest::mouseClick(dial, Qt::LeftButton, {}, middle);
    EXPECT_EQ(tug.run.given.size(), before) << "the middle is no direction";
    QTest::mouseDClick(dial, Qt::LeftButton, {}, middle);
    EXPECT_EQ(tug.run.last<core::AzimuthOrder>()->angle_rad, 0.0) << "ahead";
}

TEST(AzimuthDial, GoesRoundByWheelAndKeys) {
    Bridge tug("tug30");
    auto* const dial = tug.find<AzimuthDial>("azimuth-1");
    dial->turnTo(178.0 * kDegree_rad);
    turnWheel(dial, 1);
    QTest::keyClick(dial, Qt::Key_Up);
    EXPECT_NEAR(tug.run.last<core::AzimuthOrder>()->angle_rad, -170.0 * kDegree_rad, 1e-9)
        << "past astern it comes up the other side";
    EXPECT_EQ(tug.run.last<core::AzimuthOrder>()->shaft, 1);
    QTest::keyClick(dial, Qt::Key_Down);
    EXPECT_NEAR(tug.run.last<core::AzimuthOrder>()->angle_rad, -175.0 * kDegree_rad, 1e-9);
    tug.console->setAzimuth(0, 0.123);
    EXPECT_EQ(tug.run.last<core::AzimuthOrder>()->angle_rad, 0.123) << "a device may give parts of a degree";
    tug.settle();
    EXPECT_EQ(tug.find<AzimuthDial>("azimuth-0")->order_rad(), 0.123);
}

TEST(AzimuthDial, TheWheelTurnsTheDriveOnTopOfTheOrder) {
    Bridge tug("tug30");
    tug.find<AzimuthDial>("azimuth-0")->turnTo(30.0 * kDegree_rad);
    tug.console->setHelm(10.0 * kDegree_rad);
    tug.sail(60.0);
    const double stern =
        tug.run.world()->ships[0]->vessel.propulsion.units[0].position.x_m < 0.0 ? -1.0 : 1.0;
    EXPECT_NEAR(tug.drive(0).azimuth_rad, (30.0 + stern * 10.0) * kDegree_rad, 1e-6);
    EXPECT_NEAR(tug.drive(0).azimuthOrder_rad, 30.0 * kDegree_rad, 1e-9);
}

TEST(DriveControlsPictures, DayDuskAndNightInTwoSizes) {
    const char* const folder = std::getenv("SAGARA_UI_PICTURES");
    if (folder == nullptr) GTEST_SKIP() << "SAGARA_UI_PICTURES is not set";
    for (const char* vessel : {"ferry86", "tug30", "trawler27", "dtmb5415"}) {
        Bridge bridge(vessel);
        bridge.console->setTelegraph(0, core::TelegraphStep::SlowAhead);
        bridge.console->setPitch(0, 0.6);
        bridge.console->setAzimuth(0, 0.7);
        bridge.console->setHelm(0.1);
        bridge.sail(3.0);
        for (const auto& [palette, word] :
             {std::pair{PaletteName::Day, "day"}, std::pair{PaletteName::Dusk, "dusk"},
              std::pair{PaletteName::Night, "night"}})
            for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
                applyTheme(*qApp, palette);
                bridge.console->setColours(palette);
                bridge.console->resize(size);
                QTest::qWait(500);
                bridge.console->refresh();
                const QString name = QStringLiteral("%1/drives-%2-%3-%4.png");
                bridge.console->grab().save(name.arg(QString::fromUtf8(folder), QLatin1String(vessel),
                                                     QLatin1String(word), QString::number(size.width())));
            }
    }
    applyTheme(*qApp, PaletteName::Day);
}

}  // namespace
}  // namespace sagara::ui
