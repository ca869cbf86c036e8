#include <benchmark/benchmark.h>

#include <QApplication>
#include <QImage>
#include <cmath>

#include "tests/ui/widgets/LessonScene.h"
#include "ui/widgets/ChartWidget.h"

namespace sagara::ui {
namespace {

/// The lesson with 20 targets about the bay and a track of one hour, once a second.
ChartScene busyScene() {
    ChartScene scene = test::sailedLesson({12.0}).front();
    scene.tracks = {{}};
    for (int t = 0; t < 3600; ++t) {
        const double along = scene.path.length_m() * t / 3600.0;
        scene.tracks[0].points.push_back({1.0 * t, scene.path.pointAt(along)});
    }
    const ChartShip model = scene.targets.front();
    scene.targets.clear();
    for (int i = 0; i < 20; ++i) {
        ChartShip ship = model;
        ship.id = i;
        ship.name = QStringLiteral("Fishing vessel %1").arg(i);
        ship.position = {-2500.0 + 700.0 * (i / 4), -1500.0 + 700.0 * (i % 4)};
        ship.heading_rad = 0.7 * i;
        ship.overGround_mps = 3.0 * core::unitVector(ship.heading_rad);
        ship.hostile = i % 7 == 0;
        scene.targets.push_back(ship);
    }
    return scene;
}

struct Shown {
    ChartWidget chart;
    QImage image;

    explicit Shown(QSize size, double metresAcross) : image(size, QImage::Format_RGB32) {
        chart.resize(size);
        chart.setChart(test::galle());
        chart.setScene(busyScene());
        chart::Extent extent;
        extent.include({-0.7 * metresAcross, -0.5 * metresAcross});
        extent.include({0.3 * metresAcross, 0.5 * metresAcross});
        chart.fitTo(extent);
        chart.render(&image);
    }
};

/// Everything that moves, over the kept picture of the area.
void repaintMovingLayers(benchmark::State& bench) {
    Shown shown(QSize(static_cast<int>(bench.range(0)), static_cast<int>(bench.range(0) * 9 / 16)),
                static_cast<double>(bench.range(1)));
    const int before = shown.chart.picturesMade();
    for (auto _ : bench) shown.chart.render(&shown.image);
    bench.counters["areaDrawn"] = shown.chart.picturesMade() - before;
}
BENCHMARK(repaintMovingLayers)
    ->Args({1280, 6000})
    ->Args({1280, 1500})
    ->Args({1920, 6000})
    ->ArgNames({"width", "metres"})
    ->Unit(benchmark::kMillisecond);

/// The same with the area drawn anew, as after a zoom.
void repaintAll(benchmark::State& bench) {
    Shown shown(QSize(static_cast<int>(bench.range(0)), static_cast<int>(bench.range(0) * 9 / 16)), 6000.0);
    bool night = false;
    for (auto _ : bench) {
        shown.chart.setColours(night ? PaletteName::Night : PaletteName::Day);
        night = !night;
        shown.chart.render(&shown.image);
    }
}
BENCHMARK(repaintAll)->Arg(1280)->Arg(1920)->ArgName("width")->Unit(benchmark::kMillisecond);

/// Contours and depth areas of Galle, once per area and safety depth.
void prepareGalle(benchmark::State& bench) {
    const auto area = test::galle()->area;
    for (auto _ : bench) benchmark::DoNotOptimize(prepareChart(area, 5.0));
}
BENCHMARK(prepareGalle)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace sagara::ui

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
