// What the debriefing works out without a window.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/exercise/Lesson.h"
#include "ui/debrief/Comparison.h"
#include "ui/debrief/Marks.h"
#include "ui/debrief/PlotData.h"
#include "ui/debrief/TimeAxis.h"

namespace sagara::ui {
namespace {

core::SimTime seconds(double s) { return {std::llround(1e6 * s)}; }

/// A ship that goes north at 5 m/s, one sample a second.
std::vector<core::TrackSample> straight(const core::World& world, int from_s, int to_s, double east_m) {
    std::vector<core::TrackSample> track;
    for (int t = from_s; t <= to_s; ++t) {
        core::TrackSample sample;
        sample.tick = t * core::kTicksPerSecond;
        sample.ships.resize(world.ships.size());
        core::ShipSample& s = sample.ships[0];
        s.motion.north_m = 5.0 * t;
        s.motion.east_m = east_m;
        s.rudder_rad = 0.1;
        s.observation.overGround_mps = {5.0, 0.0};
        s.observation.underKeel_m = 6.0 - 0.1 * t;
        s.observation.clearOfShore_m = 100.0;
        s.observation.clearOfShips_m = 300.0 + std::abs(t - 20.0);
        track.push_back(std::move(sample));
    }
    return track;
}

TEST(TimeAxis, ZoomsAboutAMomentAndStaysWithinTheRun) {
    TimeAxis axis;
    axis.setWhole(seconds(0.0), seconds(1000.0));
    const double width = TimeAxis::kLeft_px + TimeAxis::kRight_px + 500.0;
    EXPECT_DOUBLE_EQ(axis.x(500.0, width), TimeAxis::kLeft_px + 250.0);
    axis.zoom(500.0, 2.0);
    EXPECT_DOUBLE_EQ(axis.from_s(), 250.0);
    EXPECT_DOUBLE_EQ(axis.to_s(), 750.0);
    EXPECT_DOUBLE_EQ(axis.x(500.0, width), TimeAxis::kLeft_px + 250.0);
    EXPECT_EQ(axis.timeAt(axis.x(300.0, width), width), seconds(300.0));
    axis.zoom(500.0, 1e6);
    EXPECT_NEAR(axis.to_s() - axis.from_s(), 10.0, 1e-9);
    axis.setCursor(seconds(990.0));
    EXPECT_LE(axis.to_s(), 1000.0);
    EXPECT_GE(axis.to_s(), 990.0) << "it follows the cursor";
    axis.showAll();
    EXPECT_FALSE(axis.zoomed());
    EXPECT_EQ(axis.timeAt(-100.0, width), seconds(0.0));
    axis.setWhole(seconds(0.0), seconds(1200.0));
    EXPECT_DOUBLE_EQ(axis.to_s(), 1200.0);
    EXPECT_EQ(axis.step_s(width, 60.0), 300.0);
}

TEST(PlotData, ShowsWhatWasSailedInTheUnitsOfItsTitles) {
    const auto world = test::lessonWorld();
    const PlotData data = plotData(*world, straight(*world, 0, 30, 10.0), nullptr);
    ASSERT_EQ(data.time_s.size(), 31u);
    EXPECT_NEAR(data.of(PlotKind::SpeedOverGround).curves[0].values[3], 5.0 * 3600.0 / 1852.0, 1e-4);
    EXPECT_NEAR(data.of(PlotKind::Rudder).curves[0].values[0], 0.1 * 180.0 / M_PI, 1e-4);
    EXPECT_EQ(data.of(PlotKind::Rudder).curves.size(), 1u) << "no orders are known";
    EXPECT_EQ(data.at(12.7), 12u);
    EXPECT_EQ(data.at(-3.0), 0u);
    EXPECT_EQ(data.at(99.0), 30u);
    ReplayOrders orders;
    orders.samples.resize(31);
    orders.samples[5].rudder_rad = -0.2;
    const PlotData with = plotData(*world, straight(*world, 0, 30, 10.0), &orders);
    EXPECT_NEAR(with.of(PlotKind::Rudder).curves[1].values[5], -0.2 * 180.0 / M_PI, 1e-4);
}

TEST(PlotAxis, HoldsTheCurvesInRoundFigures) {
    Plot plot{PlotKind::SpeedOverGround, {{{}, PlotCurve::Style::Plain, {0.0F, 12.3F}}}};
    const PlotAxis axis = plotAxis(PlotKind::SpeedOverGround, {&plot}, 4);
    EXPECT_EQ(axis.low, 0.0);
    EXPECT_EQ(axis.high, 15.0);
    EXPECT_EQ(axis.step, 5.0);
    plot.kind = PlotKind::Heading;
    plot.curves[0].values = {350.0F, 371.0F};
    const PlotAxis heading = plotAxis(PlotKind::Heading, {&plot}, 4);
    EXPECT_EQ(heading.step, 10.0);
    EXPECT_EQ(plotFigure(PlotKind::Heading, 371.0, 0), QStringLiteral("011"));
    EXPECT_EQ(plotFigure(PlotKind::Roll, std::nan(""), 1), QStringLiteral("–"));
    plot.curves[0].values = {-3.0F, 12.0F};
    const PlotAxis rudder = plotAxis(PlotKind::Rudder, {&plot}, 4);
    EXPECT_EQ(rudder.low, -rudder.high);
    EXPECT_GE(rudder.high, 12.0);
}

TEST(Comparison, TellsWhatTheTwoRunsCameTo) {
    const auto world = test::lessonWorld();
    const auto sailed = straight(*world, 0, 40, 0.0), whatIf = straight(*world, 10, 30, 30.0);
    const RunFigures a = figuresOf(*world, sailed, {}, seconds(10.0));
    EXPECT_NEAR(*a.closestShips_m, 300.0, 1e-9);
    EXPECT_NEAR(*a.closestShips_s, 20.0, 1e-9);
    EXPECT_NEAR(a.leastUnderKeel_m, 2.0, 1e-9);
    EXPECT_NEAR(a.run_m, 150.0, 1e-9) << "from the second where they part";
    std::vector<core::Event> events(1);
    events[0].tick = 25 * core::kTicksPerSecond;
    events[0].kind = core::EventKind::TaskDone;
    const RunFigures b = figuresOf(*world, whatIf, events, seconds(10.0));
    const TrackDifference apart = differenceOf(sailed, whatIf);
    EXPECT_NEAR(apart.most_m, 30.0, 1e-9);
    EXPECT_NEAR(apart.atEnd_s, 30.0, 1e-9);
    const auto rows = comparisonOf(*world, a, b, apart);
    EXPECT_EQ(rows[0].whatIf, QStringLiteral("00:30"));
    EXPECT_EQ(rows[0].difference, QStringLiteral("−00:10"));
    EXPECT_EQ(rows[2].sailed, QStringLiteral("not done"));
    EXPECT_EQ(rows[2].whatIf, QStringLiteral("00:25"));
    EXPECT_EQ(rows[2].moment, seconds(25.0));
    EXPECT_EQ(rows.back().difference, QStringLiteral("30 m, 00:30"));
}

TEST(Marks, AWeatherOrderIsToldInTheUnitsOfTheDesk) {
    core::WeatherOrder order;
    EXPECT_EQ(weatherOrderText(order), QStringLiteral("Weather ordered: as it was, over 0 s"));
    order.windSpeed_mps = 25.0 * 1852.0 / 3600.0;
    order.windFrom_rad = 240.0 * M_PI / 180.0;
    order.visibility_m = 1852.0;
    order.ramp_s = 60.0;
    EXPECT_EQ(weatherOrderText(order),
              QStringLiteral("Weather ordered: wind 25 kn, wind from 240°, visibility 1.0 M, over 60 s"));
}

}  // namespace
}  // namespace sagara::ui
