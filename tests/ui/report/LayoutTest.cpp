#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/base/Angle.h"
#include "tests/ui/report/SampleRun.h"
#include "ui/chart/Corridor.h"
#include "ui/chart/Marks.h"
#include "ui/report/Axis.h"
#include "ui/report/ChartPlan.h"
#include "ui/report/Flow.h"
#include "ui/report/FreeSpot.h"
#include "ui/report/MarkerRows.h"
#include "ui/report/SpeedLimits.h"
#include "ui/report/Text.h"
#include "ui/report/TrackMoments.h"
#include "ui/report/TrackPlots.h"

namespace sagara::report {
namespace {

using core::NorthEast;

TEST(Flow, BlocksThatDoNotFitGoToTheNextSheetWithTheirHead) {
    const auto head = std::make_shared<const Block>(Block{10.0, [](QPainter&, const QRectF&) {}});
    Block row{40.0, [](QPainter&, const QRectF&) {}};
    row.heading = head;
    EXPECT_EQ(flow(QStringLiteral("T"), {row, row}, {0, 0, 100, 100}).size(), 1u);
    const auto sheets = flow(QStringLiteral("T"), {row, row, row, row}, {0, 0, 100, 100});
    ASSERT_EQ(sheets.size(), 2u) << "head and two rows fit on the second";
    EXPECT_EQ(sheets[1].title, QStringLiteral("T, continued"));
}

TEST(Flow, ABlockHigherThanASheetStillComesOut) {
    const Block tall{500.0, [](QPainter&, const QRectF&) {}};
    EXPECT_EQ(flow(QStringLiteral("T"), {tall, tall}, {0, 0, 100, 100}).size(), 2u);
}

TEST(TextBlock, LinesFitTheWidthAndTheLastOneEndsInAnEllipsis) {
    const TextStyle style{9.0};
    const QString longText =
        QStringLiteral("Wordsandwordswithoutanyspacebetweenthematall and some with, ").repeated(9);
    const TextBlock all(longText, style, 50.0), two(longText, style, 50.0, 2);
    EXPECT_LE(all.widest_mm(), 50.0);
    EXPECT_LE(two.widest_mm(), 50.0);
    EXPECT_NEAR(two.height_mm(), 2.0 * lineHeight_mm(style), 1e-9);
    EXPECT_GT(all.height_mm(), 5.0 * lineHeight_mm(style));
    EXPECT_NEAR(TextBlock(QString(), style, 50.0).height_mm(), lineHeight_mm(style), 1e-9);
}

TEST(Axis, CoversTheValuesWithRoundTicks) {
    const std::array values{0.3, 9.7, std::nan("")};
    const Axis axis = axisFor(values, {0.0, 4.0, false, 4, {}});
    EXPECT_EQ(axis.low, 0.0);
    EXPECT_EQ(axis.high, 10.0);
    EXPECT_EQ(axis.step, 5.0);
    const Axis rudder = axisFor(std::array{-34.0, 12.0}, {0.0, 10.0, true, 4, {5, 10, 15, 20, 30}});
    EXPECT_EQ(rudder.low, -40.0);
    EXPECT_EQ(rudder.high, 40.0);
    EXPECT_GT(axisFor(std::span<const double>{}, {}).high, 0.0) << "no value, and still an axis";
}

TEST(Axis, TimeHasNoMoreThanElevenSteps) {
    for (const double end_s : {1.0, 30.0, 61.0, 1972.0, 3600.0, 20000.0, 90000.0})
        EXPECT_LE(end_s / timeStep_s(end_s), 11.0);
    EXPECT_EQ(timeStep_s(1972.0), 300.0);
}

TEST(MarkerRows, DenseNumbersUseAllRowsAndThenShare) {
    const auto widthOf = [](const std::vector<int>& numbers) {
        return 3.0 * static_cast<double>(numbers.size());
    };
    const auto one = arrangeMarkers(std::array{10.0, 40.0, 70.0}, 3, widthOf);
    ASSERT_EQ(one.size(), 3u);
    for (const Marker& marker : one) EXPECT_EQ(marker.row, 0u);
    std::vector<double> same(60, 50.0);
    std::size_t numbers = 0;
    for (const Marker& marker : arrangeMarkers(same, 3, widthOf)) {
        EXPECT_LT(marker.row, 3u);
        numbers += marker.numbers.size();
    }
    EXPECT_EQ(numbers, 60u) << "none is lost";
}

TEST(ChartView, PageAndChartAreInverse) {
    const ChartView view({20, 30, 160, 200}, {-1200.0, 340.0}, 15000.0);
    const NorthEast p{-700.0, 123.0};
    EXPECT_LT(core::distance(view.toChart(view.toPage(p)), p), 1e-9);
    EXPECT_LT(view.toPage({-600.0, 0.0}).y(), view.toPage(p).y()) << "north is up";
    EXPECT_NEAR(view.toMm(150.0), 10.0, 1e-12);
}

TEST(ChartView, DenominatorsAreRound) {
    EXPECT_EQ(denominatorAtLeast(15001.0), 17500.0);
    EXPECT_EQ(denominatorAtLeast(20000.0), 20000.0);
    EXPECT_EQ(denominatorAtMost(5833.0), 5000.0);
    EXPECT_EQ(denominatorAtMost(10000.0), 10000.0);
}

TEST(ChartPlan, TheInsetHidesNothingOfTheRun) {
    for (const RunReport& report : {test::passedRun(), test::failedRun()}) {
        const ChartPlan plan = planCharts(report, {24.5, 27, 171.5, 215});
        ASSERT_TRUE(plan.inset);
        EXPECT_TRUE(plan.inset->holds(report.track.front().position));
        for (const QPointF p : pointsToKeepFree(report, plan.main)) {
            EXPECT_TRUE(plan.main.frame().contains(p));
            EXPECT_FALSE(plan.insetBox.contains(p));
        }
    }
}

TEST(Corridor, EdgesKeepTheirDistanceFromThePath) {
    const RunReport report = test::passedRun();
    for (const double side : {-1.0, 1.0}) {
        for (const auto& line : chart::corridorEdge(report.route, report.path, side, 20.0)) {
            for (const NorthEast p : line) {
                const auto place = report.path.nearest(p, 0.0, 0.0, report.path.length_m());
                EXPECT_GE(std::abs(place.offTrack_m), 0.02 * core::kNauticalMile_m * 0.97);
                EXPECT_LE(std::abs(place.offTrack_m), 0.10 * core::kNauticalMile_m * 1.01);
            }
        }
    }
    EXPECT_TRUE(chart::corridorPieces({}, {}, 10.0).empty());
    EXPECT_TRUE(chart::pathLine(core::RoutePath{}, 10.0).empty());
}

TEST(SpeedLimits, TheRecordedOnesComeFirstThenThoseOfTheLegs) {
    RunReport report = test::passedRun();
    EXPECT_NEAR(speedLimits_mps(report).back(), 3.0 * core::kKnot_mps, 1e-9);
    for (TrackPoint& p : report.track) p.speedLimit_mps = 0.0;
    const std::vector<double> legs = speedLimits_mps(report);
    EXPECT_NEAR(legs.front(), 6.0 * core::kKnot_mps, 1e-9);
    EXPECT_NEAR(legs[legs.size() / 2], 10.0 * core::kKnot_mps, 1e-9);
    report.path = {};
    EXPECT_TRUE(speedLimits_mps(report).empty());
}

TEST(TrackMoments, AShipAtRestIsDrawnOnce) {
    std::vector<TrackPoint> track(600);
    for (std::size_t i = 0; i < track.size(); ++i) track[i].time_s = static_cast<double>(i);
    EXPECT_EQ(outlineMoments(track, 10.0, 50.0).size(), 1u);
    for (std::size_t i = 300; i < track.size(); ++i)
        track[i].position.north_m = 5.0 * static_cast<double>(i - 300);
    EXPECT_GT(outlineMoments(track, 10.0, 50.0).size(), 25u);
    EXPECT_TRUE(outlineMoments({}, 10.0, 50.0).empty());
    EXPECT_FALSE(pointAtTime({}, 3.0));
    EXPECT_EQ(pointAtTime(track, 300.0), 300u);
}

TEST(TrackPlots, HeadingGoesOnThroughNorth) {
    RunReport report;
    for (int i = 0; i < 80; ++i) {
        TrackPoint p;
        p.time_s = i;
        p.heading_rad = core::wrapTwoPi((330.0 + i) * core::kDegree_rad);
        report.track.push_back(p);
    }
    const Plot heading = trackPlots(report).at(1);
    const auto& points = heading.series.at(0).points;
    for (std::size_t i = 1; i < points.size(); ++i) EXPECT_NEAR(points[i].y() - points[i - 1].y(), 1.0, 1e-6);
    EXPECT_EQ(heading.tickText(375.0), QStringLiteral("015"));
}

TEST(Marks, LateralColoursFollowTheRegion) {
    core::Mark mark;
    mark.kind = core::MarkKind::LateralPort;
    EXPECT_EQ(chart::chartMarkOf(mark, "A").colour, ChartMark::Colour::Red);
    EXPECT_EQ(chart::chartMarkOf(mark, "B").colour, ChartMark::Colour::Green);
    mark.kind = core::MarkKind::LateralStarboard;
    EXPECT_EQ(chart::chartMarkOf(mark, "A").colour, ChartMark::Colour::Green);
    EXPECT_EQ(chart::chartMarkOf(mark, "B").colour, ChartMark::Colour::Red);
}

}  // namespace
}  // namespace sagara::report
