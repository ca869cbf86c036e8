// sagara-view: one channel of the picture, or pictures for looking at. Options here, work in the other files.
#include <CLI/CLI.hpp>
#include <cstdlib>

#include "app/files/AssetSource.h"
#include "app/view/Bench.h"
#include "app/view/Channel.h"
#include "app/view/Shots.h"
#include "render/headless/HeadlessGl.h"
#include "render/wall/LocalChannels.h"

namespace {

using namespace sagara;

/// Everything the command line can say.
struct Request {
    view::ScenarioRequest scenario;
    render::StageOptions stage;
    std::string preset = "medium";
    bool offscreen = false;
    std::string size = "1280x720";
    view::ShotOptions shots;
    std::string windowed;
    view::BenchOptions bench;
    std::string station;
    view::ChannelRequest channel;
};

bool parseSize(const std::string& text, int& width, int& height) {
    char rest = '\0';
    return std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2 && width > 0 && height > 0 &&
           width <= 8192 && height <= 8192;
}

}  // namespace

int main(int argc, char** argv) {
    Request r;
    CLI::App app("Sagara's picture of an exercise");
    app.name("sagara-view");
    app.add_option("--preset", r.preset, "low, medium or high (medium)")
        ->check(CLI::IsMember({"low", "medium", "high"}));
    app.add_flag("--offscreen", r.offscreen, "no window and no X server");
    const auto isSize = [](const std::string& text) {
        int width = 0, height = 0;
        return parseSize(text, width, height) ? std::string() : "expected WIDTHxHEIGHT, each 1 to 8192";
    };
    app.add_option("--size", r.size, "of pictures, as in 1280x720 (the default)")->check(isSize);
    app.add_option("--scenario", r.scenario.scenario, "id or file of the exercise to show");
    app.add_option("--level", r.scenario.level, "difficulty, 1 to 5 (3)")->check(CLI::Range(1, 5));
    app.add_option("--start-utc", r.scenario.changes.startUtc, "another start, as in 2027-01-15T13:00:00Z");
    app.add_option("--wind-kn", r.scenario.changes.wind_kn, "another wind");
    app.add_option("--visibility-m", r.scenario.changes.visibility_m, "another visibility");
    app.add_option("--rain", r.scenario.changes.rain, "other rain, 0 to 1");
    app.add_option("--at-s", r.shots.at_s, "second of the exercise, the pilot sailing")
        ->check(CLI::Range(0.0, 86400.0));
    app.add_option("--windowed", r.windowed, "a window of this size, as in 1280x720")->check(isSize);
    app.add_flag("--fullscreen", r.bench.fullScreen, "the whole screen");
    auto* screen = app.add_option("--screen", r.bench.screen, "monitor, from 0 left to right (the layout's)")
                       ->check(CLI::Range(0, int{link::kMostScreens} - 1));
    auto* bench =
        app.add_option("--bench", r.bench.scene, "draw this scene as fast as it goes and print figures")
            ->check(CLI::IsMember(view::benchScenes()));
    app.add_option("--frames", r.bench.frames, "how many of them (200)")->check(CLI::Range(1, 1'000'000));
    app.add_option("--channels", r.bench.channels, "pictures side by side in a bench (1)")
        ->check(CLI::Range(1, 8));
    app.add_option("--dump-frames", r.bench.dump, "leave every frame of a bench in this folder");
    auto* shots =
        app.add_option("--shots", r.shots.folder, "leave pictures from every camera in this folder");
    app.add_option("--shot", r.shots.only, "only those whose name begins so");
    auto* connect =
        app.add_option("--connect", r.station, "HOST:PORT of the station whose wall this is part of")
            ->check([&r](const std::string& text) {
                return view::parseStation(text, r.channel.station) ? std::string() : "expected HOST:PORT";
            });
    connect->needs(
        app.add_option("--channel", r.channel.station.who.channel, "name of this channel in the layout"));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    parseSize(r.size, r.shots.width, r.shots.height);
    r.scenario.assets = r.stage.assets = files::assetFolder();
    r.stage.preset = *render::presetOf(r.preset);
    r.stage.headless = r.offscreen || !render::displayIsSet();
    r.bench.window = !r.offscreen && (!r.windowed.empty() || r.bench.fullScreen);
    parseSize(r.windowed.empty() ? r.size : r.windowed, r.bench.width, r.bench.height);
    if (r.bench.window) r.stage.headless = false;
    if (*connect) {
        if (const char* token = std::getenv(wall::kTokenVariable)) r.channel.station.who.token = token;
        r.channel.fullScreen = r.bench.fullScreen;
        if (*screen) r.channel.screen = r.bench.screen;
        if (!r.windowed.empty()) r.channel.width = r.bench.width, r.channel.height = r.bench.height;
        return view::runChannel(r.stage, r.channel);
    }
    if (*bench) return view::bench(r.scenario, r.stage, r.bench);
    if (*shots) return view::takeShots(r.scenario, r.stage, r.shots);
    std::fprintf(stderr, "sagara-view: nothing to do; see --help\n");
    return 2;
}
