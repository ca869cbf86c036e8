// sagara-sim: exercises without a screen. Options here, work in app/run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <QGuiApplication>
#include <charconv>

#include "app/run/Console.h"
#include "app/run/Lists.h"
#include "app/run/RunExercise.h"
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
    CLI::App* validate =
        app.add_subcommand("validate-document", "check a vessel, area, scenario, command or rubric file");
    validate->add_option("file", r.document)->required();
    CLI::App* list = app.add_subcommand("list", "show what the database holds");
    list->add_option("what", r.list, "vessels, areas, scenarios or runs")
        ->required()
        ->check(CLI::IsMember({"vessels", "areas", "scenarios", "runs"}));
    CLI::App* backup = app.add_subcommand("backup", "copy the database while it is in use");
    backup->add_option("file", r.backup)->required();
    for (CLI::App* command : {run, replay, validate, list, backup}) {
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
    if (*replay) return replayRecording(r.replay);
    if (*validate)
        return withStore(r, [](Store& s, const Request& q) { return validateDocument(s, q.document); });
    if (*list) return withStore(r, [](Store& s, const Request& q) { return listDatabase(s, q.list); });
    return withStore(r, [](Store& s, const Request& q) { return backupDatabase(s, q.backup); });
}
