#include "app/view/Bench.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>

namespace sagara::view {
namespace {

using Clock = std::chrono::steady_clock;
using render::Lens;

constexpr double kFov_rad = std::numbers::pi / 3.0;
constexpr std::int64_t kFrame_us = 40'000;

/// How a scene changes the exercise it is made from.
struct BenchScene {
    const char* name;
    const char* startUtc;
    double wind_kn;
    double lat, lon, heading_deg;  ///< of the own ship at the start
};
constexpr BenchScene kScenes[] = {
    {"galle-entrance", "2027-01-15T05:30:00Z", 12.0, 6.0322, 80.2213, 78.0},
    {"galle-entrance-night", "2027-01-15T14:30:00Z", 12.0, 6.0322, 80.2213, 78.0},
    {"open-sea", "2027-01-15T05:30:00Z", 28.0, 5.985, 80.215, 225.0},
};

const BenchScene* findScene(const std::string& name) {
    const auto found = std::find_if(std::begin(kScenes), std::end(kScenes),
                                    [&](const BenchScene& s) { return name == s.name; });
    return found == std::end(kScenes) ? nullptr : found;
}

/// The own ship under way at 10 kn and six others around her bow, all moving straight on.
render::Moment momentAt(const core::World& world, const render::Moment& start, const BenchScene& scene,
                        core::SimTime time) {
    constexpr double kSpeed_mps = 5.0;
    const double heading = scene.heading_deg * std::numbers::pi / 180.0, t = time.seconds();
    const core::NorthEast place = world.area.frame.toLocal({scene.lat, scene.lon});
    render::Moment m = start;
    m.time = time;
    render::OwnShipPose& own = m.ships.at(0);
    own.activity = core::Activity::UnderWay;
    own.lines.clear();
    own.anchors.clear();
    own.position = place + (kSpeed_mps * t) * core::unitVector(heading);
    own.heading_rad = heading;
    own.roll_rad = 0.04 * std::sin(0.8 * t);
    own.pitch_rad = 0.015 * std::sin(1.1 * t);
    own.speedThroughWater_mps = kSpeed_mps;
    m.targets.clear();
    for (std::size_t i = 0; i < std::min<std::size_t>(6, world.targets.size()); ++i) {
        render::TargetPose target;
        target.index = i;
        target.activity = world.targets[i].activity;
        const double bearing = heading + 0.16 * (static_cast<double>(i) - 2.5);
        target.heading_rad = heading + 1.1 * static_cast<double>(i);
        target.speedThroughWater_mps = 2.0 + static_cast<double>(i);
        target.position = place + (160.0 + 70.0 * static_cast<double>(i)) * core::unitVector(bearing) +
                          (0.3 * t) * core::unitVector(target.heading_rad);
        m.targets.push_back(target);
    }
    return m;
}

double percentile(const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

double resident_MB() {
    std::ifstream in("/proc/self/statm");
    double size = 0.0, resident = 0.0;
    in >> size >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// Of all threads of the process: what counts on a machine that others use too.
double processor_ms() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto ms = [](const timeval& t) {
        return 1e3 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_usec);
    };
    return ms(usage.ru_utime) + ms(usage.ru_stime);
}

double since_ms(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

void print(const BenchOptions& o, std::vector<double> frame_ms,
           const std::vector<std::shared_ptr<render::Viewport>>& views, double firstPicture_ms,
           double processor_msEach) {
    double total_ms = 0.0;
    for (const double ms : frame_ms) total_ms += ms;
    std::sort(frame_ms.begin(), frame_ms.end());
    std::size_t triangles = 0, calls = 0;
    for (const auto& view : views) {
        triangles += view->figures().triangles;
        calls += view->figures().drawCalls;
    }
    fmt::print(
        "{} {} x {}x{}: {} frames, {:.1f} frames/s; ms: p50 {:.1f}, p95 {:.1f}, p99 {:.1f}, max {:.1f}; "
        "processor {:.1f}; {} "
        "triangles, "
        "{} draw calls; first picture after {:.0f} ms; {:.0f} MB\n",
        o.scene, views.size(), o.width, o.height, frame_ms.size(),
        1000.0 * static_cast<double>(frame_ms.size()) / total_ms, percentile(frame_ms, 0.5),
        percentile(frame_ms, 0.95), percentile(frame_ms, 0.99), frame_ms.back(), processor_msEach, triangles,
        calls, firstPicture_ms, resident_MB());
}

}  // namespace

std::vector<std::string> benchScenes() {
    std::vector<std::string> names;
    for (const BenchScene& scene : kScenes) names.emplace_back(scene.name);
    return names;
}

int bench(const ScenarioRequest& given, const render::StageOptions& stageOptions, const BenchOptions& o) {
    const auto tell = [](const std::string& text) { std::fprintf(stderr, "%s\n", text.c_str()); };
    const BenchScene* scene = findScene(o.scene);
    if (scene == nullptr) return tell("no bench scene '" + o.scene + "'"), 2;
    ScenarioRequest request = given;
    if (request.scenario.empty()) request.scenario = "basic-navigation";
    if (!request.changes.startUtc) request.changes.startUtc = scene->startUtc;
    if (!request.changes.wind_kn) request.changes.wind_kn = scene->wind_kn;
    const auto world = worldOf(request);
    if (!world) return tell(world.error()), 2;
    const render::Moment start =
        render::momentOf(core::view(**world, core::startState(**world, request.level)));

    const auto begin = Clock::now();
    auto opened = render::Stage::open(stageOptions);
    if (!opened) return tell(opened.error()), 3;
    render::Stage& stage = **opened;
    if (auto trouble = stage.show(*world)) return tell(*trouble), 3;
    for (const std::string& remark : stage.remarks()) tell(remark);
    std::vector<std::shared_ptr<render::Viewport>> views;
    for (int i = 0; i < o.channels; ++i) {
        if (!o.window) {
            views.push_back(stage.addViewport(o.width, o.height));
            continue;
        }
        auto window = stage.addWindow(
            {"Sagara " + std::to_string(i + 1), o.width, o.height, o.fullScreen, o.screen, !o.dump.empty()});
        if (!window) return tell(window.error()), 3;
        views.push_back(std::move(window).value());
    }
    if (!o.dump.empty()) std::filesystem::create_directories(o.dump);
    const Lens lens = Lens::symmetric(kFov_rad, o.width, o.height);
    std::vector<double> frame_ms;
    double firstPicture_ms = 0.0, processorBefore_ms = 0.0;
    for (int n = -1; n < o.frames; ++n) {  // the first frame compiles shaders and is not counted
        const auto frameBegin = Clock::now();
        const render::Moment moment = momentAt(**world, start, *scene, {(n + 1) * kFrame_us});
        for (std::size_t i = 0; i < views.size(); ++i) {
            const double yaw =
                kFov_rad * (static_cast<double>(i) - 0.5 * static_cast<double>(views.size() - 1));
            views[i]->setCamera(bridgeCamera(**world, moment, 0, yaw, lens));
        }
        if (auto trouble = stage.draw(moment)) return tell(*trouble), 3;
        stage.present();
        if (n < 0) {
            firstPicture_ms = since_ms(begin);
            processorBefore_ms = processor_ms();
        } else {
            frame_ms.push_back(since_ms(frameBegin));
        }
        for (std::size_t i = 0; i < views.size() && !o.dump.empty(); ++i) {
            const auto path = o.dump / fmt::format("frame-{:05}-{}.png", n + 1, i);
            if (auto trouble = writePng(*views[i]->latest(), path)) return tell(*trouble), 3;
        }
        if (views.front()->closed()) break;
    }
    if (frame_ms.empty()) return 0;
    const double each_ms = (processor_ms() - processorBefore_ms) / static_cast<double>(frame_ms.size());
    print(o, std::move(frame_ms), views, firstPicture_ms, each_ms);
    return 0;
}

}  // namespace sagara::view
