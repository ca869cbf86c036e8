// The desk driven as a trainer would, without a display and without 3D views.
#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <cmath>
#include <cstdlib>

#include "SteppedRun.h"
#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "tests/support/exercise/Lesson.h"
#include "ui/theme/Theme.h"
#include "ui/trainer/ClassroomPanel.h"
#include "ui/trainer/TraceBoard.h"
#include "ui/trainer/TrafficModel.h"
#include "ui/trainer/TrainerDesk.h"
#include "ui/widgets/ChartWidget.h"

namespace sagara::ui {
namespace {

class Desk : public ::testing::Test {
protected:
    test::SteppedRun run{test::lessonWorld(), 3};
    std::unique_ptr<TrainerDesk> desk = std::make_unique<TrainerDesk>(run, nullptr);

    void SetUp() override {
        desk->resize(1280, 720);
        desk->show();
        QTest::qWait(30);
    }
    template <typename Widget>
    Widget* find(const char* name) {
        auto* const widget = desk->findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(widget, nullptr) << name;
        return widget;
    }
    void press(const char* name) { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); }
    void sail(double seconds) {
        run.sail(seconds);
        desk->refresh();
    }
    /// A click on the chart at a place.
    void clickChart(core::NorthEast at) {
        auto* const chart = find<ChartWidget>("chart");
        chart->centreOn(at);
        QTest::mouseClick(chart, Qt::LeftButton, {}, chart->view().toScreen(at).toPoint());
    }
    template <typename Wanted>
    const Wanted& last() {
        EXPECT_FALSE(run.given().empty());
        return std::get<Wanted>(run.given().back());
    }
    bool listSays(const char* list, const QString& text) {
        auto* const items = find<QListWidget>(list);
        for (int i = 0; i < items->count(); ++i)
            if (items->item(i)->text().contains(text)) return true;
        return false;
    }
    void keep(const QString& name) {
        QApplication::processEvents();
        if (const char* folder = std::getenv("SAGARA_UI_PICTURES"))
            desk->grab().save(QString::fromUtf8(folder) + QLatin1Char('/') + name + QStringLiteral(".png"));
    }
};

TEST_F(Desk, TabsShowTheirPanelsAndKeysDoToo) {
    for (const char* name : {"ship", "events", "traffic", "class", "notes", "mission"}) {
        QTest::mouseClick(find<QToolButton>((std::string("tab-") + name).c_str()), Qt::LeftButton);
        keep(QStringLiteral("tab-") + QString::fromLatin1(name));
    }
    EXPECT_TRUE(find<QListWidget>("tasks")->isVisible());
    EXPECT_FALSE(find<QTableView>("targets")->isVisible());
    desk->showPanel(QStringLiteral("traffic"));
    EXPECT_TRUE(find<QTableView>("targets")->isVisible());
    desk->addPanel(QStringLiteral("wall"), QStringLiteral("Wall"), QStringLiteral("camera-on"),
                   new QLabel(QStringLiteral("a wall"), desk.get()));
    desk->showPanel(QStringLiteral("wall"));
    EXPECT_FALSE(find<QTableView>("targets")->isVisible());
}

TEST_F(Desk, TaskZonesAreOnTheChartAndThoseDoneAreMarked) {
    const auto zonesDone = [&] {
        const auto& zones = find<ChartWidget>("chart")->scene().zones;
        return std::count_if(zones.begin(), zones.end(),
                             [](const ChartZone& z) { return z.kind == ChartZone::Kind::Done; });
    };
    const auto& zones = find<ChartWidget>("chart")->scene().zones;
    EXPECT_GE(zones.size(), 3u);  // gate, transit, anchorage of the lesson, and where its criteria hold
    EXPECT_TRUE(
        std::any_of(zones.begin(), zones.end(), [](const ChartZone& z) { return z.corners.size() == 2; }));
    EXPECT_EQ(zonesDone(), 0);
    run.give(0, core::PilotOrder{true});
    for (int i = 0; i < 40 && zonesDone() == 0; ++i) sail(20.0);
    EXPECT_GE(zonesDone(), 1);
}

TEST_F(Desk, MeasuringToolsAreOneOrTheOther) {
    auto* const chart = find<ChartWidget>("chart");
    auto* const range = find<QAction>("range-bearing");
    auto* const rule = find<QAction>("parallel-rule");
    range->trigger();
    EXPECT_EQ(chart->tool(), ChartTools::Tool::RangeBearing);
    rule->trigger();
    EXPECT_EQ(chart->tool(), ChartTools::Tool::ParallelRule);
    EXPECT_FALSE(range->isChecked());
    rule->trigger();
    EXPECT_EQ(chart->tool(), ChartTools::Tool::None);
}

TEST_F(Desk, AShipIsAddedWhereIsClickedSteeredMovedAndTakenAway) {
    desk->showPanel(QStringLiteral("traffic"));
    auto* const table = find<QTableView>("targets");
    const int before = table->model()->rowCount();
    EXPECT_EQ(before, static_cast<int>(run.world()->targets.size()));
    const core::NorthEast at{-2500.0, 500.0};
    press("target-add");
    clickChart(at);
    auto* const dialog = find<QDialog>("add-target-dialog");
    ASSERT_NE(dialog, nullptr);
    dialog->findChild<QComboBox*>(QStringLiteral("add-type"))->setCurrentIndex(4);
    dialog->findChild<QLineEdit*>(QStringLiteral("add-name"))->setText(QStringLiteral("Sea Star"));
    dialog->findChild<QDoubleSpinBox*>(QStringLiteral("add-heading"))->setValue(90.0);
    keep(QStringLiteral("add-target-behind"));
    if (const char* folder = std::getenv("SAGARA_UI_PICTURES"))
        dialog->grab().save(QString::fromUtf8(folder) + QStringLiteral("/add-target.png"));
    QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("add-ok")), Qt::LeftButton);
    const auto& added = last<core::AddTargetOrder>();
    EXPECT_EQ(added.type, core::TargetType::Ferry);
    EXPECT_EQ(added.length_m, 60.0);
    EXPECT_LT(core::distance(added.position, at), 60.0);
    sail(1.0);
    ASSERT_EQ(table->model()->rowCount(), before + 1);
    EXPECT_EQ(table->model()->index(before, 0).data().toString(), QStringLiteral("Sea Star"));
    EXPECT_EQ(table->model()->index(before, TrafficModel::Course).data().toString(), QStringLiteral("090°"));
    EXPECT_EQ(find<ChartWidget>("chart")->scene().targets.back().name, QStringLiteral("Sea Star"));

    table->selectRow(before);
    find<QDoubleSpinBox>("target-heading")->setValue(180.0);
    find<QDoubleSpinBox>("target-speed")->setValue(6.0);
    press("target-steer");
    EXPECT_NEAR(last<core::SteerTargetOrder>().speed_mps, 6.0 * core::kKnot_mps, 1e-9);
    EXPECT_NEAR(last<core::SteerTargetOrder>().heading_rad, core::kPi, 0.01);

    press("target-route");
    clickChart({-2500.0, 1500.0});
    clickChart({-3500.0, 1500.0});
    keep(QStringLiteral("desk-route-by-clicks"));
    press("target-route");
    const auto& route = last<core::RouteTargetOrder>();
    EXPECT_EQ(route.target, static_cast<std::uint32_t>(before));
    EXPECT_EQ(route.points.size(), 2u);

    press("target-move");
    auto* const chart = find<ChartWidget>("chart");
    ASSERT_EQ(chart->scene().handles.size(), 1u);
    chart->centreOn(chart->scene().handles[0].position);
    const QPoint from = chart->view().toScreen(chart->scene().handles[0].position).toPoint();
    QTest::mousePress(chart, Qt::LeftButton, {}, from);
    QTest::mouseMove(chart, from + QPoint(40, 0));
    QTest::mouseRelease(chart, Qt::LeftButton, {}, from + QPoint(40, 0));
    EXPECT_NEAR(last<core::MoveTargetOrder>().position.east_m - run.latest()->targets.back().position.east_m,
                chart->view().toMetres(40.0), 3.0 * chart->view().metresPerPixel());
    EXPECT_TRUE(chart->scene().handles.empty());

    press("target-stop");
    EXPECT_EQ(last<core::TargetOrder>().action, core::TargetAction::Stop);
    sail(1.0);
    EXPECT_EQ(find<QPushButton>("target-stop")->text(), QStringLiteral("Go on"));
    press("target-there");
    EXPECT_EQ(last<core::TargetOrder>().action, core::TargetAction::Remove);
    sail(1.0);
    EXPECT_EQ(table->model()->index(before, TrafficModel::Speed).data().toString(), QStringLiteral("–"));
    EXPECT_EQ(find<QPushButton>("target-there")->text(), QStringLiteral("Bring her"));
    EXPECT_FALSE(find<QPushButton>("target-steer")->isEnabled());
}

TEST_F(Desk, AThreatIsToldFromTheOthers) {
    core::AddTargetOrder order;
    order.name = "Skiff";
    order.type = core::TargetType::FastCraft;
    order.hostile = true;
    order.position = {-2000.0, 0.0};
    order.heading_rad = 1.0;
    order.speed_mps = 12.0;
    order.length_m = 8.0;
    order.beam_m = 2.5;
    order.draught_m = 0.6;
    run.give(0, order);
    sail(1.0);
    auto* const model = find<QTableView>("targets")->model();
    EXPECT_TRUE(model->index(model->rowCount() - 1, 0).data().toString().startsWith(QStringLiteral("⚠")));
    EXPECT_TRUE(listSays("log", QStringLiteral("Skiff appears")));
}

TEST_F(Desk, NotesAndBookmarksAreKeptWithTheirMoment) {
    desk->showPanel(QStringLiteral("notes"));
    sail(5.0);
    find<QAction>("bookmark")->trigger();
    EXPECT_TRUE(last<core::NoteOrder>().bookmark);
    EXPECT_TRUE(find<QLabel>("notes-state")->text().contains(QStringLiteral("1 waiting")));
    find<QAction>("note")->trigger();
    QTest::keyClicks(find<QLineEdit>("note-text"), QStringLiteral("No lookout aft"));
    EXPECT_TRUE(find<QPushButton>("add-note")->isEnabled());
    QTest::keyClick(find<QLineEdit>("note-text"), Qt::Key_Return);
    EXPECT_EQ(last<core::NoteOrder>().text, "No lookout aft");
    run.give(0, core::ReportOrder{core::ReportKind::PortControl});
    sail(1.0);
    auto* const list = find<QListWidget>("notes-list");
    ASSERT_EQ(list->count(), 3);
    EXPECT_EQ(list->item(0)->text(), QStringLiteral("00:05  Bookmark"));
    EXPECT_EQ(list->item(1)->text(), QStringLiteral("00:05  Note: No lookout aft"));
    EXPECT_TRUE(list->item(2)->text().contains(QStringLiteral("port control")));
    keep(QStringLiteral("desk-notes"));

    core::State earlier = core::startState(*run.world(), 3);
    run.goBackTo(earlier);
    desk->refresh();
    EXPECT_EQ(list->count(), 0);
}

TEST_F(Desk, AFaultThatTheScenarioBringsTicksItsBoxAndGivesNoOrder) {
    desk->showPanel(QStringLiteral("events"));
    auto* const jam = find<QCheckBox>("fault-jam");
    EXPECT_FALSE(jam->isChecked());
    QTest::mouseClick(find<QPushButton>("event-rudder-jams"), Qt::LeftButton);
    sail(1.0);
    EXPECT_TRUE(jam->isChecked());
    EXPECT_FALSE(find<QPushButton>("event-rudder-jams")->isEnabled());
    EXPECT_EQ(run.given().size(), 1u);  // the event, no fault of the desk's own
    jam->setChecked(false);
    EXPECT_TRUE(last<core::FaultOrder>().mended);
    desk->refresh();
    EXPECT_FALSE(jam->isChecked());  // ordered, not yet carried out
    sail(1.0);
    EXPECT_FALSE(jam->isChecked());
    find<QCheckBox>("fault-pumps")->setChecked(true);
    sail(1.0);
    EXPECT_TRUE(find<QCheckBox>("fault-pumps")->isChecked());
    EXPECT_FALSE(find<QCheckBox>("fault-pump")->isChecked());
    find<QCheckBox>("fault-engine-1")->setChecked(true);
    sail(1.0);
    EXPECT_TRUE(run.latest()->ships[0].enginesFailed[1]);
    find<QCheckBox>("fault-thruster-0")->setChecked(true);
    sail(1.0);
    EXPECT_TRUE(run.latest()->ships[0].thrusters[0].failed);
}

TEST_F(Desk, OnlyWeatherThatWasTouchedIsOrdered) {
    desk->showPanel(QStringLiteral("events"));
    EXPECT_FALSE(find<QPushButton>("apply-weather")->isEnabled());
    find<QDoubleSpinBox>("swell2-height")->setValue(2.5);
    find<QDoubleSpinBox>("swell2-from")->setValue(270.0);
    find<QDoubleSpinBox>("gusts")->setValue(30.0);
    find<QDoubleSpinBox>("current")->setValue(2.0);
    find<QDoubleSpinBox>("current-to")->setValue(90.0);
    find<QDoubleSpinBox>("weather-ramp")->setValue(10.0);
    press("apply-weather");
    const auto& order = last<core::WeatherOrder>();
    EXPECT_FALSE(order.windSpeed_mps);
    EXPECT_FALSE(order.swells[0]);
    ASSERT_TRUE(order.swells[1]);
    EXPECT_NEAR(core::wrapTwoPi(order.swells[1]->wavesTo_rad), core::kPi / 2, 1e-9);
    sail(15.0);
    EXPECT_NEAR(run.latest()->weather.current.east_m, 2.0 * core::kKnot_mps, 1e-6);
    EXPECT_NEAR(run.latest()->weather.wind.gustiness, 0.3, 1e-9);
    EXPECT_NEAR(run.latest()->weather.swells[1].significantHeight_m, 2.5, 1e-6);
    EXPECT_NEAR(find<QDoubleSpinBox>("current")->value(), 2.0, 1e-6);
    keep(QStringLiteral("desk-weather"));
}

TEST_F(Desk, ForceArrowsComeAndGo) {
    auto* const chart = find<ChartWidget>("chart");
    run.give(0, core::PilotOrder{true});
    sail(200.0);
    EXPECT_TRUE(chart->scene().forces.empty());
    find<QAction>("show-forces")->trigger();
    EXPECT_GE(chart->scene().forces.size(), 2u);
    chart->centreOn(run.latest()->ships[0].motion.position());
    for (int i = 0; i < 8; ++i) chart->zoomIn();
    chart->centreOn(run.latest()->ships[0].motion.position());
    keep(QStringLiteral("desk-forces"));
    find<QAction>("show-forces")->trigger();
    EXPECT_TRUE(chart->scene().forces.empty());
}

TEST_F(Desk, TheClassroomHoldsMotionsAndDrawsTraces) {
    desk->showPanel(QStringLiteral("class"));
    press("free-0");  // surge held
    EXPECT_EQ(last<core::FreezeMotionOrder>().free, core::kAllMotions & ~1);
    sail(1.0);
    EXPECT_EQ(run.latest()->ships[0].freeMotions, core::kAllMotions & ~1);
    EXPECT_FALSE(find<QPushButton>("free-0")->isChecked());
    EXPECT_TRUE(find<QPushButton>("free-all")->isEnabled());
    press("free-all");
    sail(1.0);
    EXPECT_TRUE(find<QPushButton>("free-0")->isChecked());
    for (int i = 0; i < 20; ++i) sail(0.2);
    const auto& series = desk->findChild<ClassroomPanel*>()->series();
    EXPECT_GE(series.samples().size(), 20u);
    EXPECT_EQ(find<TraceBoard>("traces")->valueNow(Trace::SpeedKept), QStringLiteral("–"));
}

TEST_F(Desk, AfterTheEndNothingCanBeOrdered) {
    run.give(0, core::FinishOrder{});
    sail(1.0);
    for (const char* name : {"target-add", "target-steer", "add-bookmark", "free-0", "apply-weather"})
        EXPECT_FALSE(find<QPushButton>(name)->isEnabled()) << name;
    const std::size_t before = run.given().size();
    find<QAction>("bookmark")->trigger();
    EXPECT_EQ(run.given().size(), before);
}

TEST(TraceSeries, TheSpeedKeptInATurnIsOfTheSpeedBeforeIt) {
    TraceSeries series;
    core::ShipMotion m;
    m.surge_mps = 8.0;
    double time_s = 0.0;
    const auto sail = [&](double seconds, double turn_degps) {
        for (const double end_s = time_s + seconds; time_s < end_s; time_s += 0.2) {
            m.yawRate_radps = turn_degps * core::kDegree_rad;
            series.add(time_s, m);
        }
    };
    const auto now = [&](Trace trace) {
        return series.samples().back().values[static_cast<std::size_t>(trace)];
    };
    sail(30.0, 0.0);
    EXPECT_TRUE(std::isnan(now(Trace::SpeedKept)));
    for (int i = 0; i < 8; ++i) sail(2.0, i % 2 == 0 ? 1.0 : -1.0);  // yawing in waves is no turn
    EXPECT_TRUE(std::isnan(now(Trace::SpeedKept)));
    sail(6.0, 1.0);
    m.surge_mps = 6.0;
    m.sway_mps = -1.0;
    sail(10.0, 1.0);
    EXPECT_NEAR(now(Trace::SpeedKept), 100.0 * std::hypot(6.0, 1.0) / 8.0, 0.01);
    EXPECT_NEAR(now(Trace::Drift), std::atan2(-1.0, 6.0) / core::kDegree_rad, 1e-9);
    EXPECT_NEAR(now(Trace::Yaw), 60.0, 1e-9);
    EXPECT_NEAR(series.speedBefore_mps().value_or(0.0), 8.0, 1e-6);
    sail(40.0, 0.0);
    EXPECT_FALSE(series.speedBefore_mps());
    series.add(3.0, m);  // back in time
    EXPECT_EQ(series.samples().size(), 1u);
}

/// Under way in a turn in a seaway, every panel, by day and by night, at both sizes.
TEST(DeskPictures, AreMadeWhenAskedFor) {
    const char* const folder = std::getenv("SAGARA_UI_PICTURES");
    if (folder == nullptr) GTEST_SKIP() << "SAGARA_UI_PICTURES is not set";
    test::SteppedRun run(test::lessonWorld(), 4);
    run.give(0, core::PilotOrder{true});
    run.sail(420.0);
    core::AddTargetOrder order;
    order.name = "Skiff";
    order.type = core::TargetType::FastCraft;
    order.hostile = true;
    order.position = run.latest()->ships[0].motion.position() + core::NorthEast{-600.0, 300.0};
    order.speed_mps = 12.0;
    order.length_m = 8.0;
    order.beam_m = 2.5;
    order.draught_m = 0.6;
    run.give(0, order);
    auto* const application = static_cast<QApplication*>(QApplication::instance());
    for (const auto& [palette, name] :
         {std::pair{PaletteName::Day, "day"}, std::pair{PaletteName::Night, "night"}}) {
        applyTheme(*application, palette);
        for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
            TrainerDesk desk(run, nullptr);
            desk.setColours(palette);
            desk.resize(size);
            desk.show();
            desk.findChild<QAction*>(QStringLiteral("show-forces"))->trigger();
            desk.showPanel(QStringLiteral("class"));
            run.give(0, core::HelmOrder{0.5});
            for (int i = 0; i < 150; ++i) {
                run.sail(0.2);
                desk.refresh();
            }
            QTest::qWait(100);
            auto* const chart = desk.findChild<ChartWidget*>(QStringLiteral("chart"));
            chart->centreOn(run.latest()->ships[0].motion.position());
            for (const char* panel : {"mission", "ship", "events", "traffic", "class", "notes"}) {
                desk.showPanel(QString::fromLatin1(panel));
                QTest::qWait(20);
                desk.refresh();
                desk.grab().save(
                    QStringLiteral("%1/desk-%2-%3-%4.png")
                        .arg(QString::fromUtf8(folder), QString::fromLatin1(panel), QString::fromLatin1(name))
                        .arg(size.width()));
            }
        }
    }
    applyTheme(*application, PaletteName::Day);
}

}  // namespace
}  // namespace sagara::ui

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
