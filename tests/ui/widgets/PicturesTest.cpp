#include <gtest/gtest.h>

#include <QDir>
#include <QImage>
#include <QMouseEvent>
#include <QTest>

#include "core/base/Units.h"
#include "tests/ui/widgets/LessonScene.h"
#include "ui/widgets/ChartWidget.h"

namespace sagara::ui::test {
namespace {

/// Pictures to look at: SAGARA_UI_PICTURES names a folder.
class Pictures : public ::testing::Test {
protected:
    void SetUp() override {
        if (folder().isEmpty()) GTEST_SKIP() << "set SAGARA_UI_PICTURES to a folder";
        QDir().mkpath(folder());
    }
    static QString folder() { return qEnvironmentVariable("SAGARA_UI_PICTURES"); }
    static void save(ChartWidget& chart, const QString& name, double ratio = 1.0) {
        QImage image(ratio * chart.size(), QImage::Format_RGB32);
        image.setDevicePixelRatio(ratio);
        chart.render(&image);
        EXPECT_TRUE(image.save(folder() + u'/' + name + QStringLiteral(".png")));
    }
};

chart::Extent about(core::NorthEast centre, double half_m) {
    chart::Extent extent;
    extent.include(centre - core::NorthEast{half_m, half_m});
    extent.include(centre + core::NorthEast{half_m, half_m});
    return extent;
}

TEST_F(Pictures, TheLessonAtEveryZoomInEveryPalette) {
    const auto scenes = sailedLesson({2.5, 6.0, 14.0, 60.0});
    const std::array<QSize, 2> sizes{QSize(1280, 720), QSize(1920, 1080)};
    const std::array<const char*, 3> palettes{"day", "dusk", "night"};
    for (const QSize size : sizes) {
        ChartWidget chart;
        chart.resize(size);
        chart.setChart(galle());
        chart.show();
        const QString end = QStringLiteral("-%1x%2").arg(size.width()).arg(size.height());
        chart.setScene(scenes[2]);
        chart.fitArea();
        save(chart, QStringLiteral("area") + end);
        const core::NorthEast ship = scenes[2].ownShips[0].position;
        for (const double half_m : {2400.0, 1200.0, 450.0, 150.0}) {
            chart.fitTo(about(ship, half_m));
            save(chart, QStringLiteral("bay-%1m").arg(half_m) + end);
        }
        chart.setScene(scenes[0]);
        for (const double half_m : {450.0, 130.0}) {
            chart.fitTo(about(scenes[0].ownShips[0].position, half_m));
            save(chart, QStringLiteral("harbour-%1m").arg(half_m) + end);
        }
        chart.setScene(scenes[3]);
        chart.fitTo(about(scenes[3].ownShips[0].position, 500.0));
        save(chart, QStringLiteral("anchored") + end);
        chart.setScene(scenes[1]);
        chart.follow(true);
        chart.setHeadUp(true);
        save(chart, QStringLiteral("head-up") + end);
        chart.setHeadUp(false);
        chart.fitTo(about(scenes[1].ownShips[0].position, 1000.0));
        for (std::size_t i = 0; i < palettes.size(); ++i) {
            chart.setColours(static_cast<PaletteName>(i));
            save(chart, QString::fromLatin1(palettes[i]) + end);
        }
        chart.setChart(nullptr);
        chart.setScene({});
        chart.setColours(PaletteName::Day);
        save(chart, QStringLiteral("empty") + end);
    }
    ChartWidget chart;
    chart.resize(1280, 720);
    chart.setChart(galle());
    chart.setScene(scenes[1]);
    chart.show();
    chart.fitTo(about(scenes[1].ownShips[0].position, 600.0));
    save(chart, QStringLiteral("high-dpi"), 2.0);
}

TEST_F(Pictures, ToolsAndHandles) {
    ChartScene scene = sailedLesson({8.0}).front();
    for (std::size_t i = 0; i < scene.route.waypoints.size(); ++i)
        scene.handles.push_back({static_cast<int>(i), scene.route.waypoints[i].position, {}});
    ChartWidget chart;
    chart.resize(1280, 720);
    chart.setChart(galle());
    chart.setScene(scene);
    chart.show();
    chart.fitTo(about(scene.ownShips[0].position, 1100.0));
    const QPoint ship = chart.view().toScreen(scene.ownShips[0].position).toPoint();
    const auto drag = [&](QPoint from, QPoint to) {
        QTest::mousePress(&chart, Qt::LeftButton, Qt::NoModifier, from);
        QMouseEvent move(QEvent::MouseMove, to, chart.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QCoreApplication::sendEvent(&chart, &move);
        QTest::mouseRelease(&chart, Qt::LeftButton, Qt::NoModifier, to);
    };
    chart.chooseTool(ChartTools::Tool::ParallelRule);
    drag(ship + QPoint(60, 120), ship + QPoint(-110, 160));
    chart.chooseTool(ChartTools::Tool::RangeBearing);
    drag(ship, ship + QPoint(250, -90));
    save(chart, QStringLiteral("tools"));
    chart.setColours(PaletteName::Dusk);
    save(chart, QStringLiteral("tools-dusk"));
}

}  // namespace
}  // namespace sagara::ui::test
