// sagara-sim: exercises without a screen. Options here, work in app/run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <QGuiApplication>
#include <charconv>

#include "app/run/Console.h"
#include "app/run/Lists.h"
#include "app/run/RunExercise.h"
#include "app/run/RunWall.h"
#include "app/run/ValidateDocument.h"
#include "db/DbError.h"

namespace {

using namespace sagara::run;

constexpr double kLongest_s = 7.0 * 86400.0;

/// Everything the command line can say.
struct Request {
    std::optional<std::filesystem::path> data;
    RunOptions run;
    std::string helm = "none";
    ReplayOptions replay;
    WallRunOptions wall;
    std::vector<std::uint32_t> wallSize_px;
    std::filesystem::path document;
    std::string list;
    std::filesystem::path backup;
};

/// A number from least to most. CLI11 lets NaN pass, and takes a seed of -1 for another one.
template <typename T>
CLI::Validator between(T least, T most) {
    const std::string accepted = fmt::format("{} to {}", least, most);
    return {[=](std::string& text) {
                T value{};
                const char* end = text.data() + text.size();
                const auto [stop, error] = std::from_chars(text.data(), end, value);
                const bool good = error == std::errc() && stop == end && value >= least && value <= most;
                return good ? std::string() : "is " + text + ", expected " + accepted;
            },
            accepted};
}

/// What a recording that is taken up again brings along itself.
void tellUnused(const CLI::App& run) {
    for (const char* option :
         {"--scenario", "--helm", "--level", "--commands", "--seed", "--trainee", "--type", "--record"}) {
        if (run.count(option)) tell(std::string(option) + " is not used: --resume has it from the recording");
    }
}

CLI::App* addRun(CLI::App& app, Request& r) {
    CLI::App* run = app.add_subcommand("run", "sail an exercise, record and grade it");
    auto* scenario = run->add_option("--scenario", r.run.scenario, "id in the database, or a file");
    run->add_option("--helm", r.helm, "who sails: the scripted pilot, or nobody")
        ->check(CLI::IsMember({"pilot", "none"}));
    run->add_option("--level", r.run.level, "difficulty, 1 to 5 (3)")->check(between(1, 5));
    run->add_option("--commands", r.run.commands, "command file");
    run->add_flag("--fast", r.run.fast, "as fast as the machine can");
    run->add_option("--duration-s", r.run.duration_s, "end after so many seconds")
        ->check(between(0.0, kLongest_s));
    run->add_option("--seed", r.run.seed, "of sea and gusts (1)")
        ->check(between<std::uint64_t>(0, UINT64_MAX));
    run->add_option("--trainee", r.run.trainee, "who sails, for the record; added to the roster when new");
    run->add_option("--type", r.run.type, "familiarise, train, assess, self-study or demo (train)")
        ->check(CLI::IsMember({"familiarise", "train", "assess", "self-study", "demo"}));
    run->add_option("--record", r.run.record, "recording file (else in the data folder)");
    run->add_option("--track", r.run.track, "track file, CSV");
    run->add_option("--track-hz", r.run.track_Hz, "rows a second in it (1)")->check(between(0.01, 50.0));
    run->add_option("--report", r.run.report, "report file, PDF");
    auto* resume = run->add_option("--resume", r.run.resume, "take up a recording that was broken off");
    run->add_flag("--json", r.run.json, "one JSON object on standard output");
    run->callback([=] {
        if (scenario->count() + resume->count() == 0) throw CLI::RequiredError("--scenario or --resume");
        if (resume->count()) tellUnused(*run);
    });
    return run;
}

CLI::App* addReplay(CLI::App& app, Request& r) {
    CLI::App* replay =
        app.add_subcommand("replay", "run a recording again to the bit, or grade it by another rubric");
    replay->add_option("recording", r.replay.recording, "recording file")->required();
    replay->add_option("--until-s", r.replay.until_s, "stop at this second")->check(between(0.0, kLongest_s));
    replay->add_option("--track", r.replay.track, "track file, CSV");
    replay->add_option("--track-hz", r.replay.track_Hz, "rows a second in it (1)")
        ->check(between(0.01, 50.0));
    replay->add_option("--rubric", r.replay.rubric, "grade by the mission of this rubric file");
    replay->add_option("--report", r.replay.report, "report file, PDF");
    replay->add_flag("--json", r.replay.json, "one JSON object on standard output");
    return replay;
}

CLI::App* addWall(CLI::App& app, Request& r) {
    CLI::App* wall = app.add_subcommand("wall", "run an exercise with its wall, without a station");
    wall->add_option("--scenario", r.wall.scenario, "id in the database, or a file")->required();
    wall->add_option("--layout", r.wall.layout, "id under assets/walls, or a file (desk-3x60)");
    wall->add_option("--helm", r.helm, "who sails: the scripted pilot, or nobody")
        ->check(CLI::IsMember({"pilot", "none"}));
    wall->add_option("--level", r.wall.level, "difficulty, 1 to 5 (3)")->check(CLI::Range(1, 5));
    wall->add_option("--seed", r.wall.seed, "of sea and gusts (1)");
    wall->add_option("--start-utc", r.wall.changes.startUtc, "another start, as in 2027-01-15T13:00:00Z");
    wall->add_option("--wind-kn", r.wall.changes.wind_kn, "another wind")->check(between(0.0, 100.0));
    wall->add_option("--visibility-m", r.wall.changes.visibility_m, "another visibility")
        ->check(between(10.0, 100'000.0));
    wall->add_option("--rain", r.wall.changes.rain, "other rain, 0 to 1")->check(between(0.0, 1.0));
    wall->add_option("--at-s", r.wall.at_s, "open after the pilot has sailed so long (0)")
        ->check(between(0.0, 86'400.0));
    wall->add_flag("--fullscreen", r.wall.fullScreen, "each channel over a screen of its own, left to right");
    wall->add_flag("--offscreen", r.wall.offscreen, "channels without windows")->excludes("--fullscreen");
    wall->add_option("--size", r.wallSize_px, "of every channel, in pixels: 640x360")
        ->delimiter('x')
        ->expected(2)
        ->check(CLI::Range(64, 4096));
    wall->add_option("--rate-hz", r.wall.rate_Hz, "frames a second at most (60)")
        ->check(CLI::Range(1.0, 240.0));
    wall->add_flag("--fast", r.wall.fast, "frames of 1/rate-hz, as fast as the channels draw");
    wall->add_option("--duration-s", r.wall.duration_s, "of the exercise (10)")
        ->check(CLI::Range(0.0, 7.0 * 86400.0));
    wall->add_option("--shots", r.wall.shots, "folder for pictures of all channels side by side");
    wall->add_option("--shot-every-s", r.wall.shotEvery_s, "time between them (2)")
        ->check(CLI::Range(0.1, 3600.0));
    wall->add_option("--view", r.wall.view, "channel program (else sagara-view beside this one)");
    wall->add_option("--view-option", r.wall.viewArguments,
                     "passed on to it, for example --view-option=--preset=low");
    wall->add_flag("--listen", r.wall.listen, "take channels from other PCs; the token is in SAGARA_TOKEN");
    wall->add_option("--port", r.wall.port, "to listen on (any)");
    wall->add_option("--kill-every-s", r.wall.killEvery_s, "for trials: kill a channel so often")
        ->check(CLI::Range(0.5, 86400.0));
    wall->add_option("--order-every-s", r.wall.orderEvery_s,
                     "for trials: a helm order so often, and how soon it shows")
        ->check(between(0.1, 86'400.0))
        ->excludes("--fast");
    return wall;
}

int withStore(const Request& r, int (*work)(Store&, const Request&)) {
    auto store = Store::open(r.data);
    if (!store) return tell(store.error()), kBadRequest;
    try {
        return work(**store, r);
    } catch (const sagara::db::DbError& e) {
        return tell(e.what()), kMachineFailed;
    }
}

}  // namespace

int main(int argc, char** argv) {
    Request r;
    CLI::App app("Sagara without a screen: run, replay and grade exercises");
    app.name("sagara-sim");
    app.require_subcommand(1);
    CLI::App* run = addRun(app, r);
    CLI::App* replay = addReplay(app, r);
    CLI::App* wall = addWall(app, r);
    CLI::App* validate = app.add_subcommand("validate-document",
                                            "check a vessel, area, scenario, wall, command or rubric file");
    validate->add_option("file", r.document)->required();
    CLI::App* list = app.add_subcommand("list", "show what the database holds");
    list->add_option("what", r.list, "vessels, areas, scenarios or runs")
        ->required()
        ->check(CLI::IsMember({"vessels", "areas", "scenarios", "runs"}));
    CLI::App* backup = app.add_subcommand("backup", "copy the database while it is in use");
    backup->add_option("file", r.backup)->required();
    for (CLI::App* command : {run, replay, wall, validate, list, backup}) {
        command->add_option("--data", r.data, "data folder (else the XDG one)");
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? kDone : kBadRequest;
    }

    // Fonts and PDF need a QGuiApplication; the offscreen platform needs no display.
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication qt(argc, argv);
    r.run.pilot = r.helm == "pilot";
    if (*run) return withStore(r, [](Store& s, const Request& q) { return runExercise(s, q.run); });
    r.wall.pilot = r.run.pilot;
    if (r.wallSize_px.size() == 2) r.wall.size_px.emplace(r.wallSize_px[0], r.wallSize_px[1]);
    if (*wall) return withStore(r, [](Store& s, const Request& q) { return runWall(s, q.wall); });
    if (*replay) return replayRecording(r.replay);
    if (*validate)
        return withStore(r, [](Store& s, const Request& q) { return validateDocument(s, q.document); });
    if (*list) return withStore(r, [](Store& s, const Request& q) { return listDatabase(s, q.list); });
    return withStore(r, [](Store& s, const Request& q) { return backupDatabase(s, q.backup); });
}
