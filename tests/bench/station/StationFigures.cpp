// Figures of the station (issue 4, section 7): start to first picture, stalls of the windows, memory, and
// pictures a second of three 640x360 channels and the desk's two viewports while the lesson runs. Wants an
// idle machine.
#include <QApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>

#include "StallMeter.h"
#include "app/station/DeskPage.h"
#include "app/station/Station.h"
#include "ui/trainer/TrainerDesk.h"
#include "ui/viewport/ViewportWidget.h"

namespace sagara::station {
namespace {

double resident_MB() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024.0;
    return 0.0;
}

int figures(double measure_s) {
    const QTemporaryDir folder;
    QElapsedTimer sinceStart;
    sinceStart.start();
    auto store = run::Store::open(std::filesystem::path(folder.path().toStdString()));
    if (!store) return std::fprintf(stderr, "%s\n", store.error().c_str()), 2;
    Station station(**store, render::StageOptions{SAGARA_ASSETS, presetOfThisMachine(), true});
    station.resize(1280, 720);
    station.show();
    RunRequest request;
    request.scenario = "basic-navigation";
    request.pilot = true;
    if (const auto trouble = station.openRun(request))
        return std::fprintf(stderr, "%s\n", trouble->c_str()), 2;
    auto* const page = dynamic_cast<DeskPage*>(station.page());
    const auto views = page->findChildren<ui::ViewportWidget*>();
    if (!QTest::qWaitFor([&] { return !views.empty() && views[0]->picturesShown() > 0; }, 30'000)) return 1;
    std::printf("from the start to the first picture on the desk: %.1f s\n",
                1e-3 * static_cast<double>(sinceStart.elapsed()));

    const std::string wallFile = folder.filePath(QStringLiteral("wall.json")).toStdString();
    std::ofstream(wallFile)
        << R"({"document": "wall", "version": 1, "id": "three", "name": "Three", "channels": [
 {"name": "port", "yaw_deg": -60, "fieldOfView_deg": 60, "size_px": [640, 360]},
 {"name": "ahead", "yaw_deg": 0, "fieldOfView_deg": 60, "size_px": [640, 360]},
 {"name": "starboard", "yaw_deg": 60, "fieldOfView_deg": 60, "size_px": [640, 360]}]})";
    page->wall().start(wallFile, ui::WallPlacement::Hidden);
    page->run().start();
    const auto inStep = [&] {
        const auto channels = page->wall().status().channels;
        return channels.size() == 3 && std::all_of(channels.begin(), channels.end(),
                                                   [](const auto& c) { return c.state == "in step"; });
    };
    if (!QTest::qWaitFor(inStep, 60'000)) return std::fprintf(stderr, "the wall did not come into step\n"), 1;
    QTest::qWait(3000);
    StallMeter stalls;
    stalls.begin();
    const auto before = views[0]->picturesShown(), before2 = views[1]->picturesShown();
    QElapsedTimer clock;
    clock.start();
    QTest::qWait(static_cast<int>(1000.0 * measure_s));
    const double took_s = 1e-3 * static_cast<double>(clock.elapsed());
    std::printf("over %.0f s with three 640x360 channels and two viewports:\n", took_s);
    for (const auto& c : page->wall().status().channels)
        std::printf("  channel %-10s %5.1f frames/s, skew %.1f ms, lost %d times\n", c.name.c_str(),
                    c.rate_Hz, c.skew_ms, c.timesLost);
    std::printf("  viewports          %5.1f and %.1f pictures/s\n",
                static_cast<double>(views[0]->picturesShown() - before) / took_s,
                static_cast<double>(views[1]->picturesShown() - before2) / took_s);
    std::printf("  %s\n  station %.0f MB resident\n", stalls.text().c_str(), resident_MB());
    return 0;
}

}  // namespace
}  // namespace sagara::station

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    return sagara::station::figures(argc > 1 ? std::stod(argv[1]) : 20.0);
}
