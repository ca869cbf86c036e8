// The trainee's console driven as a trainee would, without a display and without the scene.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabWidget>
#include <QTest>
#include <QTextBrowser>
#include <QTimer>
#include <QToolButton>

#include "SteppedRun.h"
#include "core/bridge/AisCarriage.h"
#include "tests/support/exercise/Lesson.h"
#include "ui/trainee/AisTargets.h"
#include "ui/trainee/ConsolePage.h"
#include "ui/trainee/HelmWheel.h"
#include "ui/trainee/ShaftTelegraph.h"
#include "ui/trainee/ThrusterLever.h"
#include "ui/trainee/ViewPanel.h"
#include "ui/widgets/ChartWidget.h"

namespace sagara::ui {
namespace {

using core::kDegree_rad;

class TraineesConsole : public ::testing::Test {
protected:
    void SetUp() override { open({}); }
    void open(ConsoleOptions options) {
        m_console.reset();
        m_run = std::make_unique<test::SteppedRun>(test::lessonWorld());
        m_console = std::make_unique<TraineeConsole>(*m_run, nullptr, options);
        m_console->resize(1280, 720);
        m_console->show();
        QApplication::processEvents();
    }
    void takeWatch() {
        QTest::mouseClick(find<QPushButton>("take-watch"), Qt::LeftButton);
        m_run->start();
        m_console->refresh();
    }
    void sail(double seconds) {
        m_run->sail(seconds);
        m_console->refresh();
    }
    template <typename Widget>
    Widget* find(const char* name) {
        auto* const widget = m_console->findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(widget, nullptr) << name;
        return widget;
    }
    void key(Qt::Key which, Qt::KeyboardModifiers with = Qt::NoModifier) {
        QTest::keyClick(m_console.get(), which, with);
    }
    const core::OwnShipView& own() const { return m_run->latest()->ships[0]; }

    std::unique_ptr<test::SteppedRun> m_run;
    std::unique_ptr<TraineeConsole> m_console;
};

TEST_F(TraineesConsole, ShowsTheBriefingBeforeTheBridge) {
    EXPECT_FALSE(m_console->onWatch());
    const QString text = find<QTextBrowser>("briefing")->toPlainText();
    for (const auto& task : m_run->world()->mission.tasks)
        EXPECT_TRUE(text.contains(QString::fromStdString(task->title())));
    for (const auto& event : m_run->world()->events)
        EXPECT_FALSE(text.contains(QString::fromStdString(event.title))) << event.title;
    QSignalSpy taken(m_console.get(), &TraineeConsole::watchTaken);
    takeWatch();
    EXPECT_TRUE(m_console->onWatch());
    EXPECT_EQ(taken.count(), 1);
    QTest::mouseClick(find<QPushButton>("show-briefing"), Qt::LeftButton);
    EXPECT_FALSE(m_console->onWatch());
}

TEST_F(TraineesConsole, StartsTheRunOnlyWhenItIsToldTo) {
    QTest::mouseClick(find<QPushButton>("take-watch"), Qt::LeftButton);
    EXPECT_FALSE(m_run->running()) << "the trainer starts";
    EXPECT_EQ(find<QLabel>("console-state")->text(), QStringLiteral("Waiting for the trainer to start"));
    ConsoleOptions alone;
    alone.startsRun = alone.showRunControls = true;
    open(alone);
    QTest::mouseClick(find<QPushButton>("take-watch"), Qt::LeftButton);
    EXPECT_TRUE(m_run->running());
    QTest::mouseClick(find<QPushButton>("console-start"), Qt::LeftButton);
    EXPECT_FALSE(m_run->running());
    QSignalSpy end(m_console.get(), &TraineeConsole::endWanted);
    QTest::mouseClick(find<QPushButton>("console-end"), Qt::LeftButton);
    EXPECT_EQ(end.count(), 1);
}

TEST_F(TraineesConsole, HelmOrdersOfWheelKeysAndDevicesReachTheRun) {
    takeWatch();
    for (int i = 0; i < 3; ++i) key(Qt::Key_Right);
    key(Qt::Key_Right, Qt::ShiftModifier);
    sail(0.1);
    EXPECT_NEAR(own().rudderOrder_rad, 8.0 * kDegree_rad, 1e-9);
    key(Qt::Key_M);
    sail(0.1);
    EXPECT_EQ(own().rudderOrder_rad, 0.0);
    auto* const wheel = find<console::HelmWheel>("helm");
    QTest::mouseClick(wheel, Qt::LeftButton, {}, QPoint(8, wheel->height() / 2));
    sail(0.1);
    EXPECT_LT(own().rudderOrder_rad, -20.0 * kDegree_rad) << "far on the port side of the arc";
    QSignalSpy given(m_console.get(), &TraineeConsole::helmGiven);
    m_console->setHelm(0.123);
    sail(0.1);
    EXPECT_NEAR(own().rudderOrder_rad, 0.123, 1e-12) << "a device may give parts of a degree";
    EXPECT_EQ(given.count(), 1);
}

TEST_F(TraineesConsole, TelegraphsOrderTheStepsOfTheVessel) {
    takeWatch();
    const auto& table = m_run->world()->ships[0]->vessel.propulsion.telegraph_rps;
    key(Qt::Key_PageUp);
    key(Qt::Key_PageUp);
    sail(0.1);
    for (const double order_rps : own().shaftOrders_rps) EXPECT_EQ(order_rps, table[6]) << "slow ahead";
    auto* const port = find<console::ShaftTelegraph>("telegraph-0");
    QTest::mouseClick(port, Qt::LeftButton, {}, QPoint(port->width() / 2, port->height() - 32));
    sail(0.1);
    EXPECT_LT(own().shaftOrders_rps[0], table[3]);
    EXPECT_EQ(own().shaftOrders_rps[1], table[6]) << "the other shaft goes on";
    m_console->setTelegraph(1, core::TelegraphStep::Stop);
    sail(0.1);
    EXPECT_EQ(own().shaftOrders_rps[1], 0.0);
    m_console->setTelegraph(7, core::TelegraphStep::Stop);  // no such shaft: nothing
}

TEST_F(TraineesConsole, TheThrusterHasALeverOnlyWhereThereIsOne) {
    takeWatch();
    auto* const lever = find<console::ThrusterLever>("thruster-0");
    EXPECT_EQ(m_console->findChild<QWidget*>(QStringLiteral("thruster-1")), nullptr);
    QTest::mouseClick(lever, Qt::LeftButton, {}, QPoint(lever->width() - 6, lever->height() / 2));
    sail(0.1);
    EXPECT_EQ(own().thrusters[0].order, 1.0) << "far to starboard";
    sail(5.0);
    EXPECT_NEAR(own().thrusters[0].share, 1.0, 1e-9);
    QTest::mouseDClick(lever, Qt::LeftButton);
    sail(0.1);
    EXPECT_EQ(own().thrusters[0].order, 0.0);
    QSignalSpy given(m_console.get(), &TraineeConsole::thrusterGiven);
    m_console->setThruster(0, -0.4);
    m_console->setThruster(3, -0.4);  // no such thruster: nothing
    sail(0.1);
    EXPECT_EQ(own().thrusters[0].order, -0.4);
    EXPECT_EQ(given.count(), 1);
    m_run->give(0, core::FaultOrder{core::Fault::Thruster, 0, false});
    sail(1.0);
    EXPECT_TRUE(own().thrusters[0].failed);
}

TEST_F(TraineesConsole, FollowsWhatOthersOrder) {
    takeWatch();
    m_run->give(0, core::HelmOrder{10.0 * kDegree_rad});
    sail(1.0);
    EXPECT_NEAR(find<console::HelmWheel>("helm")->order_rad(), 10.0 * kDegree_rad, 1e-9);
    key(Qt::Key_Right);
    EXPECT_NEAR(m_run->last<core::HelmOrder>()->rudder_rad, 11.0 * kDegree_rad, 1e-9);
}

TEST_F(TraineesConsole, LinesAndAnchorsObeyTheBridge) {
    takeWatch();
    QTest::mouseClick(find<QToolButton>("line-1-1"), Qt::LeftButton);
    sail(0.5);
    EXPECT_EQ(own().lines[1].status, core::LineStatus::Slacking);
    QTest::mouseClick(find<QToolButton>("line-1-0"), Qt::LeftButton);
    sail(0.5);
    EXPECT_EQ(own().lines[1].status, core::LineStatus::Fast);
    QTest::mouseClick(find<QToolButton>("line-1-3"), Qt::LeftButton);
    sail(0.5);
    EXPECT_FALSE(own().lines[1].onBollard());
    EXPECT_FALSE(find<QToolButton>("line-1-0")->isEnabled());

    find<QTabWidget>("deck")->setCurrentIndex(1);
    find<QDoubleSpinBox>("anchor-shackles-0")->setValue(1.0);
    QTest::mouseClick(find<QToolButton>("anchor-0-0"), Qt::LeftButton);
    sail(30.0);
    EXPECT_EQ(own().anchors[0].status, core::AnchorStatus::Held);
    EXPECT_NEAR(own().anchors[0].cableOut_m, core::kShackle_m, 2.0);
    EXPECT_TRUE(find<QLabel>("anchor-state-0")->text().startsWith(QStringLiteral("1.0 shackles")))
        << find<QLabel>("anchor-state-0")->text().toStdString();
    QTest::mouseClick(find<QToolButton>("anchor-0-3"), Qt::LeftButton);
    sail(1.0);
    EXPECT_EQ(own().anchors[0].status, core::AnchorStatus::Heaving);
}

TEST_F(TraineesConsole, TheAutopilotIsSetToATrueHeading) {
    takeWatch();
    find<QSpinBox>("steer-set")->setValue(45);
    QTest::mouseClick(find<QPushButton>("steer-heading"), Qt::LeftButton);
    sail(0.1);
    EXPECT_EQ(own().autopilot.mode, core::AutopilotMode::Heading);
    const double convergence_rad = m_run->world()->area.frame.convergence_rad(own().motion.position());
    EXPECT_NEAR(own().autopilot.setHeading_rad - convergence_rad, 45.0 * kDegree_rad, 1e-5);
    key(Qt::Key_Left);
    sail(0.1);
    EXPECT_EQ(own().autopilot.mode, core::AutopilotMode::Off) << "a hand on the wheel takes over";
}

TEST_F(TraineesConsole, ReportsAreOrdersOfTheRecording) {
    takeWatch();
    for (const auto& [name, kind] : {std::pair{"report-port", core::ReportKind::PortControl},
                                     std::pair{"report-anchored", core::ReportKind::Anchored},
                                     std::pair{"report-mob", core::ReportKind::ManOverboard}}) {
        find<QPushButton>(name)->click();
        ASSERT_NE(m_run->last<core::ReportOrder>(), nullptr);
        EXPECT_EQ(m_run->last<core::ReportOrder>()->kind, kind);
    }
    sail(0.1);
    const auto events = m_run->eventsFrom(0);
    EXPECT_EQ(std::count_if(events.begin(), events.end(),
                            [](const core::Event& e) { return e.kind == core::EventKind::Reported; }),
              3);
}

TEST_F(TraineesConsole, AlarmsOfTheShipSoundUntilAcknowledged) {
    takeWatch();
    QSignalSpy alarm(m_console.get(), &TraineeConsole::alarm);
    m_run->give(0, core::FaultOrder{core::Fault::Engine, 1, false});
    sail(1.0);
    EXPECT_TRUE(find<QLabel>("alarms")->text().contains(QStringLiteral("Main engine 2 shut down")));
    ASSERT_EQ(alarm.count(), 1);
    EXPECT_TRUE(alarm[0][0].toBool());
    key(Qt::Key_A);
    ASSERT_EQ(alarm.count(), 2);
    EXPECT_FALSE(alarm[1][0].toBool());
    EXPECT_TRUE(find<QLabel>("alarms")->text().contains(QStringLiteral("Main engine 2 shut down")));
    m_run->give(0, core::FaultOrder{core::Fault::Engine, 1, true});
    sail(1.0);
    EXPECT_FALSE(find<QLabel>("alarms")->text().contains(QStringLiteral("engine")));
    find<QDoubleSpinBox>("depth-alarm")->setValue(50.0);
    m_console->refresh();
    EXPECT_TRUE(find<QLabel>("alarms")->text().contains(QStringLiteral("Shallow water")));
}

TEST_F(TraineesConsole, AJammedRudderIsFoundByItself) {
    takeWatch();
    m_run->give(0, core::FaultOrder{core::Fault::SteeringJam, 0, false});
    sail(0.5);
    m_console->setHelm(0.3);
    for (int i = 0; i < 20; ++i) sail(0.5);
    EXPECT_TRUE(find<QLabel>("alarms")->text().contains(QStringLiteral("Rudder does not follow")))
        << find<QLabel>("alarms")->text().toStdString();
}

TEST_F(TraineesConsole, TheHornSoundsAsLongAsItIsHeld) {
    takeWatch();
    QSignalSpy horn(m_console.get(), &TraineeConsole::horn);
    QTest::mousePress(find<QPushButton>("horn"), Qt::LeftButton);
    QTest::mouseRelease(find<QPushButton>("horn"), Qt::LeftButton);
    QTest::keyPress(m_console.get(), Qt::Key_H);
    QTest::keyRelease(m_console.get(), Qt::Key_H);
    ASSERT_EQ(horn.count(), 4);
    EXPECT_TRUE(horn[2][0].toBool());
    EXPECT_FALSE(horn[3][0].toBool());
}

TEST_F(TraineesConsole, BearingsTakenInTheViewAreListed) {
    takeWatch();
    auto* const view = m_console->findChild<console::ViewPanel*>();
    ASSERT_NE(view, nullptr);
    const core::ShipMotion& m = own().motion;
    Q_EMIT view->bearingTaken(m.heading_rad + 0.5);
    Q_EMIT view->bearingTaken(m.heading_rad - 0.25);
    auto* const list = find<QListWidget>("bearings");
    ASSERT_EQ(list->count(), 2);
    EXPECT_TRUE(list->item(0)->text().contains(QStringLiteral("P 014° rel.")));
    EXPECT_TRUE(list->item(1)->text().contains(QStringLiteral("S 029° rel.")));
    find<QPushButton>("bearing-remove")->click();
    EXPECT_EQ(list->count(), 0);
}

TEST_F(TraineesConsole, ItsChartHasOnlyShipsThatSendAis) {
    takeWatch();
    m_run->give(0, core::DifficultyOrder{5});
    for (std::uint32_t i = 0; i < m_run->world()->targets.size(); ++i)
        m_run->give(0, core::TargetOrder{i, core::TargetAction::Appear, 0.0});
    sail(1.0);
    ASSERT_EQ(m_run->latest()->targets.size(), m_run->world()->targets.size());
    std::size_t sending = 0;
    for (const core::TargetLayout& target : m_run->world()->targets)
        sending += core::carriesAis(target) ? 1 : 0;
    ASSERT_GT(sending, 0u);
    ASSERT_LT(sending, m_run->world()->targets.size()) << "the lesson has boats that send nothing";
    const auto& shown = find<ChartWidget>("chart")->scene().targets;
    EXPECT_EQ(shown.size(), sending);
    for (const ChartShip& ship : shown) {
        EXPECT_GE(ship.length_m, core::kAisLength_m) << ship.name.toStdString();
        EXPECT_FALSE(ship.hostile);
    }
}

TEST_F(TraineesConsole, TheChartCanBePrinted) {
    takeWatch();
    bool asked = false;
    QTimer::singleShot(0, [&] {
        for (QWidget* window : QApplication::topLevelWidgets()) {
            auto* const box = qobject_cast<QMessageBox*>(window);
            if (box == nullptr || box->objectName() != QStringLiteral("print-chart")) continue;
            asked = true;
            box->reject();
        }
    });
    find<QAction>("chart-print")->trigger();
    EXPECT_TRUE(asked);
}

TEST_F(TraineesConsole, ABeatKeepsTheWindowFree) {
    takeWatch();
    auto* const tabs = find<QTabWidget>("console-tabs");
    for (int tab = 0; tab < 3; ++tab) {
        tabs->setCurrentIndex(tab);
        QApplication::processEvents();
        double worst_ms = 0.0;
        for (int i = 0; i < 10; ++i) {
            m_run->sail(1.0);
            QElapsedTimer clock;
            clock.start();
            m_console->drawFrame();
            m_console->refresh();
            m_console->grab();
            worst_ms = std::max(worst_ms, static_cast<double>(clock.nsecsElapsed()) * 1e-6);
        }
        std::printf("console, tab %d: %.0f ms for all of the window, worst of ten\n", tab, worst_ms);
        EXPECT_LT(worst_ms, 500.0) << "100 ms on an idle machine";
    }
}

TEST_F(TraineesConsole, IsFixedOnceTheExerciseIsOver) {
    takeWatch();
    m_run->give(0, core::FinishOrder{});
    sail(0.1);
    EXPECT_EQ(find<QLabel>("console-state")->text(), QStringLiteral("The exercise is over"));
    const std::size_t orders = m_run->given.size();
    key(Qt::Key_Right);
    m_console->setHelm(0.2);
    EXPECT_EQ(m_run->given.size(), orders);
}

TEST(ConsolePages, ArePagesOfTheStation) {
    test::SteppedRun run(test::lessonWorld());
    ConsolePage page(run, nullptr, {});
    EXPECT_EQ(page.helpTopic(), QStringLiteral("console"));
    EXPECT_TRUE(page.mayLeave());
    page.setColours(PaletteName::Night);
}

}  // namespace
}  // namespace sagara::ui
