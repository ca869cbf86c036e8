#include "ui/widgets/ChartWidget.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

#include "core/base/Units.h"
#include "tests/ui/widgets/LessonScene.h"
#include "ui/widgets/ChartTexts.h"

/// The widget driven with mouse and keys, as a trainer does.
namespace sagara::ui::test {
namespace {

using core::NorthEast;

chart::Extent about(NorthEast centre, double half_m) {
    chart::Extent extent;
    extent.include(centre - NorthEast{half_m, half_m});
    extent.include(centre + NorthEast{half_m, half_m});
    return extent;
}

class OnTheChart : public ::testing::Test {
protected:
    void SetUp() override {
        chart.resize(1280, 720);
        chart.setChart(galle());
        chart.setScene(lessonAtBerth());
        chart.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&chart));
    }

    QPoint at(NorthEast p) const { return chart.view().toScreen(p).toPoint(); }
    NorthEast under(QPoint p) const { return chart.view().toChart(p); }
    /// One notch is 120.
    void wheel(QPoint p, int delta) {
        QWheelEvent event(p, chart.mapToGlobal(p), {}, {0, delta}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&chart, &event);
    }
    void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers keys = Qt::NoModifier) {
        press(from, button, keys);
        move(0.5 * (from + to), button, keys);
        move(to, button, keys);
        QTest::mouseRelease(&chart, button, keys, to);
    }
    void press(QPoint p, Qt::MouseButton button = Qt::LeftButton,
               Qt::KeyboardModifiers keys = Qt::NoModifier) {
        QTest::mousePress(&chart, button, keys, p);
    }
    void move(QPoint p, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers keys = Qt::NoModifier) {
        QMouseEvent event(QEvent::MouseMove, p, chart.mapToGlobal(p), Qt::NoButton, button, keys);
        QCoreApplication::sendEvent(&chart, &event);
    }
    QImage picture() {
        QImage image(chart.size(), QImage::Format_RGB32);
        chart.render(&image);
        return image;
    }

    ChartWidget chart;
};

TEST_F(OnTheChart, ShowsTheWholeAreaAtFirst) {
    for (const NorthEast corner : {galle()->extent.southWest, galle()->extent.northEast})
        EXPECT_TRUE(chart.rect().contains(at(corner)));
    chart.resize(1920, 1080);
    EXPECT_GT(at(galle()->extent.southWest).y() - at(galle()->extent.northEast).y(), 900)
        << "and when it grows";
}

TEST_F(OnTheChart, TheWheelZoomsAboutTheCursor) {
    const QPoint cursor(900, 150);
    const NorthEast place = under(cursor);
    const double before = chart.view().metresPerPixel();
    wheel(cursor, 240);
    EXPECT_LT(core::distance(under(cursor), place), 1e-6);
    EXPECT_NEAR(before / chart.view().metresPerPixel(), 1.25 * 1.25, 1e-9);
    wheel(cursor, -240);
    EXPECT_NEAR(chart.view().metresPerPixel(), before, 1e-9);
}

TEST_F(OnTheChart, ADragMovesThePlaceWithTheHand) {
    const QPoint from(300, 300), to(437, 255);
    const NorthEast place = under(from);
    drag(from, to);
    EXPECT_LT(core::distance(under(to), place), 1e-6);
    drag(to, from, Qt::MiddleButton);
    EXPECT_LT(core::distance(under(from), place), 1e-6);
}

TEST_F(OnTheChart, KeysPanZoomAndGoHome) {
    chart.zoomIn();
    const NorthEast centre = chart.view().centre();
    QTest::keyClick(&chart, Qt::Key_Right);
    EXPECT_GT(chart.view().centre().east_m, centre.east_m);
    QTest::keyClick(&chart, Qt::Key_Left);
    QTest::keyClick(&chart, Qt::Key_Up);
    EXPECT_GT(chart.view().centre().north_m, centre.north_m);
    QTest::keyClick(&chart, Qt::Key_Down);
    EXPECT_LT(core::distance(chart.view().centre(), centre), 1e-6);
    const double scale = chart.view().metresPerPixel();
    QTest::keyClick(&chart, Qt::Key_Plus);
    EXPECT_LT(chart.view().metresPerPixel(), scale);
    QTest::keyClick(&chart, Qt::Key_Minus);
    EXPECT_NEAR(chart.view().metresPerPixel(), scale, 1e-9);
    QSignalSpy following(&chart, &ChartWidget::followingChanged);
    QTest::keyClick(&chart, Qt::Key_Home);
    EXPECT_LT(core::distance(chart.view().centre(), chart.scene().ownShips[0].position), 1e-6);
    EXPECT_TRUE(chart.following());
    QTest::keyClick(&chart, Qt::Key_Left);
    EXPECT_FALSE(chart.following());
    EXPECT_EQ(following.count(), 2);
}

TEST_F(OnTheChart, ItFollowsTheShipAndTurnsWithHer) {
    chart.follow(true);
    chart.setHeadUp(true);
    ChartShip ship = chart.scene().ownShips[0];
    ship.position = {-300.0, 40.0};
    ship.heading_rad = 2.0;
    chart.setOwnShips({ship});
    EXPECT_NEAR(chart.view().up_rad(), std::round(2.0 / core::kDegree_rad) * core::kDegree_rad, 1e-12);
    EXPECT_EQ(at(ship.position).x(), 640);
}

TEST_F(OnTheChart, TheCursorReadsPositionAndDepth) {
    QSignalSpy cursor(&chart, &ChartWidget::cursorMoved);
    const QPoint p(500, 560);
    move(p, Qt::NoButton);
    ASSERT_EQ(cursor.count(), 1);
    EXPECT_EQ(cursor[0][0].value<NorthEast>(), under(p));
    EXPECT_EQ(chart.readout().position, positionText(galle()->area->frame, under(p)));
    EXPECT_EQ(chart.readout().depth, QStringLiteral("depth: ") + depthText(*galle(), under(p)));
    EXPECT_EQ(chart.readout().measured,
              rangeBearingText(measure(galle()->area->frame, chart.scene().ownShips[0].position, under(p))));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&chart, &leave);
    EXPECT_EQ(chart.readout().depth, QStringLiteral("position of SLNS Sagara"));
}

TEST_F(OnTheChart, RangeAndBearingAgreeWithGeodesy) {
    chart.chooseTool(ChartTools::Tool::RangeBearing);
    const QPoint from(420, 500), to(700, 380);
    const NorthEast a = under(from), b = under(to);
    drag(from, to);
    EXPECT_EQ(under(from), a) << "the chart does not move";
    ASSERT_TRUE(chart.tools().range());
    EXPECT_EQ(chart.tools().range()->from, a);
    EXPECT_EQ(chart.tools().range()->to, b);
    const core::LocalFrame& frame = galle()->area->frame;
    const NorthEast exact = core::LocalFrame(frame.toGeo(a)).toLocal(frame.toGeo(b));
    const double bearing_deg = std::fmod(core::bearing_rad({}, exact) / core::kDegree_rad + 360.0, 360.0);
    const std::string words = chart.readout().measured.toStdString();
    EXPECT_EQ(std::stoi(words.substr(0, 3)), static_cast<int>(std::lround(bearing_deg)));
    EXPECT_NEAR(std::stod(words.substr(words.find(' '))), core::length(exact) / core::kNauticalMile_m, 0.005);
    EXPECT_NE(words.find(" cables"), std::string::npos);
}

TEST_F(OnTheChart, ARangeBegunOnTheOwnShipGoesWithHer) {
    chart.fitTo(about(chart.scene().ownShips[0].position, 400.0));
    chart.chooseTool(ChartTools::Tool::RangeBearing);
    drag(at(chart.scene().ownShips[0].position), QPoint(800, 400));
    ASSERT_TRUE(chart.tools().range()->fromOwnShip);
    ChartShip ship = chart.scene().ownShips[0];
    ship.position = ship.position + NorthEast{100.0, 0.0};
    chart.setOwnShips({ship});
    EXPECT_EQ(chart.tools().range()->from, ship.position);
    EXPECT_EQ(chart.readout().measuredFrom, QStringLiteral("from own ship"));
}

TEST_F(OnTheChart, EscapeTakesBackOneStepAtATime) {
    QSignalSpy tool(&chart, &ChartWidget::toolChanged);
    chart.chooseTool(ChartTools::Tool::RangeBearing);
    drag({420, 500}, {700, 380});
    QTest::keyClick(&chart, Qt::Key_Escape);
    EXPECT_FALSE(chart.tools().range());
    EXPECT_EQ(chart.tool(), ChartTools::Tool::RangeBearing);
    QTest::keyClick(&chart, Qt::Key_Escape);
    EXPECT_EQ(chart.tool(), ChartTools::Tool::None);
    EXPECT_EQ(tool.count(), 2);
}

TEST_F(OnTheChart, ARuleLaidOnALegTakesItsCourseAndKeepsIt) {
    const auto& waypoints = chart.scene().route.waypoints;
    const NorthEast a = waypoints[5].position, b = waypoints[6].position;
    chart.fitTo(about(0.5 * (a + b), 1500.0));
    chart.chooseTool(ChartTools::Tool::ParallelRule);
    drag(at(0.5 * (a + b)), at(0.5 * (a + b)) + QPoint(120, 40));
    ASSERT_TRUE(chart.tools().rule());
    EXPECT_NEAR(chart.tools().rule()->direction_rad, core::bearing_rad(a, b), 1e-12);
    EXPECT_TRUE(chart.readout().measured.contains(QStringLiteral("of the own ship")));
    const double before = chart.tools().rule()->direction_rad;
    drag({300, 300}, {500, 300}, Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_NE(chart.tools().rule()->direction_rad, before) << "Shift turns it";
}

TEST_F(OnTheChart, AClickPicksWhatLiesThere) {
    qRegisterMetaType<ChartPick>();
    QSignalSpy picked(&chart, &ChartWidget::picked);
    const core::Area& area = *galle()->area;
    const ChartScene& scene = chart.scene();
    struct Row {
        ChartPick::Kind kind;
        NorthEast place;
        const char* words;
        double half_m;
    };
    const NorthEast quay = area.berths[0].face.a + 0.2 * (area.berths[0].face.b - area.berths[0].face.a);
    const std::vector<Row> rows{
        {ChartPick::Kind::OwnShip, scene.ownShips[0].position, "SLNS Sagara", 500},
        {ChartPick::Kind::Target, scene.targets[1].position, "Sea Fortune", 500},
        {ChartPick::Kind::Waypoint, scene.route.waypoints[5].position, "Off fort light", 500},
        {ChartPick::Kind::Mark, area.marks[0].position, "Fl(2) W 15s 28m 18M", 500},
        {ChartPick::Kind::Berth, quay, "New Pier", 300},
        {ChartPick::Kind::Place, area.findPlace("anch_sw_monsoon")->position, "SW-monsoon", 500},
        {ChartPick::Kind::Zone, scene.zones[1].centre + NorthEast{200.0, 100.0}, "Transit", 900},
        {ChartPick::Kind::Nothing, {-4000.0, -3000.0}, "", 200}};
    for (const Row& row : rows) {
        chart.fitTo(about(row.place, row.half_m));
        picked.clear();
        QTest::mouseClick(&chart, Qt::LeftButton, Qt::NoModifier, at(row.place));
        ASSERT_EQ(picked.count(), 1) << row.words;
        const ChartPick pick = picked[0][0].value<ChartPick>();
        EXPECT_EQ(pick.kind, row.kind) << row.words << ": " << pick.text.toStdString();
        EXPECT_TRUE(pick.text.contains(QString::fromLatin1(row.words))) << pick.text.toStdString();
    }
}

TEST_F(OnTheChart, WhatIsSwitchedOffIsNeitherDrawnNorPicked) {
    const NorthEast ship = chart.scene().ownShips[0].position;
    chart.fitTo(about(ship, 400.0));
    for (unsigned bit = 0; bit < 17; ++bit) {
        const auto layer = static_cast<ChartLayer>(1u << bit);
        if (layer == ChartLayer::Track || layer == ChartLayer::Vectors || layer == ChartLayer::Anchors ||
            layer == ChartLayer::Prediction) {
            continue;  // she lies at her berth
        }
        const QImage with = picture();
        chart.setLayerShown(layer, false);
        EXPECT_NE(picture(), with) << "layer " << bit;
        chart.setLayerShown(layer, true);
        EXPECT_EQ(picture(), with) << "layer " << bit << " comes back as it was";
    }
    chart.setLayerShown(ChartLayer::OwnShips, false);
    EXPECT_NE(chart.pickAt(chart.view().toScreen(ship)).kind, ChartPick::Kind::OwnShip);
}

TEST_F(OnTheChart, AHandleIsDraggedToItsNewPlace) {
    const auto& waypoints = chart.scene().route.waypoints;
    chart.fitTo(about(waypoints[5].position, 1500.0));
    chart.setHandles(
        {{41, waypoints[5].position, QStringLiteral("Waypoint 6")}, {42, waypoints[6].position, {}}});
    QSignalSpy moved(&chart, &ChartWidget::handleMoved), dragged(&chart, &ChartWidget::handleDragged);
    const QPoint from = at(waypoints[5].position), to = from + QPoint(140, -60);
    drag(from, to);
    ASSERT_EQ(moved.count(), 1);
    EXPECT_EQ(moved[0][0].toInt(), 41);
    EXPECT_EQ(moved[0][1].value<NorthEast>(), under(to));
    EXPECT_GE(dragged.count(), 2);
    EXPECT_EQ(chart.scene().handles[0].position, under(to));

    press(to);
    move(to + QPoint(50, 50));
    QTest::keyClick(&chart, Qt::Key_Escape);
    QTest::mouseRelease(&chart, Qt::LeftButton, Qt::NoModifier, to + QPoint(50, 50));
    EXPECT_EQ(moved.count(), 1) << "a drag that is cancelled moves nothing";
    EXPECT_EQ(chart.scene().handles[0].position, under(to));
    EXPECT_EQ(dragged.last()[1].value<NorthEast>(), under(to));
}

TEST_F(OnTheChart, TheAreaIsDrawnAnewOnlyWhenTheViewNeedsIt) {
    (void)picture();
    const int before = chart.picturesMade();
    ChartShip ship = chart.scene().ownShips[0];
    for (int i = 0; i < 20; ++i) {
        ship.position = ship.position + NorthEast{5.0, 0.0};
        chart.setOwnShips({ship});
        chart.extendTrack(0, {1.0 * i, ship.position});
        (void)picture();
    }
    drag({300, 300}, {340, 320});
    (void)picture();
    EXPECT_EQ(chart.picturesMade(), before) << "moving things and small drags reuse the picture";
    chart.zoomIn();
    (void)picture();
    EXPECT_EQ(chart.picturesMade(), before + 1);
    chart.setColours(PaletteName::Night);
    (void)picture();
    EXPECT_EQ(chart.picturesMade(), before + 2);
}

TEST_F(OnTheChart, TheSameSceneGivesTheSamePicture) {
    ChartWidget other;
    other.resize(1280, 720);
    other.setChart(galle());
    other.setScene(lessonAtBerth());
    QImage image(other.size(), QImage::Format_RGB32);
    other.render(&image);
    chart.clearFocus();
    EXPECT_EQ(picture(), image);
}

TEST(EmptyChart, NoAreaNoShipsNoHarm) {
    ChartWidget chart;
    chart.resize(800, 600);
    chart.show();
    chart.chooseTool(ChartTools::Tool::ParallelRule);
    for (const Qt::Key key : {Qt::Key_Home, Qt::Key_Plus, Qt::Key_Left, Qt::Key_Escape})
        QTest::keyClick(&chart, key);
    QTest::mouseClick(&chart, Qt::LeftButton, Qt::NoModifier, {100, 100});
    chart.setHeadUp(true);
    chart.follow(true);
    EXPECT_FALSE(chart.grab().isNull());
    EXPECT_EQ(chart.pickAt({100, 100}).kind, ChartPick::Kind::Nothing);
    chart.setChart(galle());
    EXPECT_FALSE(chart.grab().isNull());
    chart.setChart(prepareChart(std::make_shared<const core::Area>(), 5.0));
    chart.resize(320, 240);
    EXPECT_FALSE(chart.grab().isNull()) << "an area with nothing in it";
    chart.resize(1, 1);
    EXPECT_FALSE(chart.grab().isNull());
}

TEST(PreparedChartOfGalle, HasTheContoursAndOneOfThemForSafety) {
    std::vector<double> depths_m;
    for (const auto& contour : galle()->contours) depths_m.push_back(contour.depth_m);
    EXPECT_EQ(depths_m, (std::vector<double>{2, 10, 20, 5}));
    EXPECT_TRUE(galle()->contours.back().safety);
    const auto odd = prepareChart(galle()->area, 4.2);
    EXPECT_EQ(odd->contours.size(), 5u);
    EXPECT_EQ(odd->contours.back().depth_m, 4.2);
    for (const auto& grid : odd->grids) {
        EXPECT_EQ(grid.depths.front().from_m, 0.0);
        EXPECT_EQ(grid.depths.back().from_m, 10.0);
    }
}

}  // namespace
}  // namespace sagara::ui::test
