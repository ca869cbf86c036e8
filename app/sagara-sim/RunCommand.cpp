#include "Between.h"
#include "Commands.h"
#include "app/run/Console.h"
#include "app/run/RunExercise.h"

namespace sagara::sim {

using namespace sagara::run;

namespace {

/// What a recording that is taken up again brings along itself.
void tellUnused(const CLI::App& run) {
    for (const char* option :
         {"--scenario", "--helm", "--level", "--commands", "--seed", "--trainee", "--type", "--record"}) {
        if (run.count(option)) tell(std::string(option) + " is not used: --resume has it from the recording");
    }
}

}  // namespace

void addRun(Commands& commands) {
    auto o = std::make_shared<RunOptions>();
    auto helm = std::make_shared<std::string>("none");
    CLI::App* run = commands.add("run", "sail an exercise, record and grade it", [=](Store& store) {
        o->pilot = *helm == "pilot";
        return runExercise(store, *o);
    });
    auto* scenario = run->add_option("--scenario", o->scenario, "id in the database, or a file");
    run->add_option("--helm", *helm, "who sails: the scripted pilot, or nobody")
        ->check(CLI::IsMember({"pilot", "none"}));
    run->add_option("--level", o->level, "difficulty, 1 to 5 (3)")->check(between(1, 5));
    run->add_option("--commands", o->commands, "command file");
    run->add_flag("--fast", o->fast, "as fast as the machine can");
    run->add_option("--duration-s", o->duration_s, "end after so many seconds")
        ->check(between(0.0, kLongest_s));
    run->add_option("--seed", o->seed, "of sea and gusts (1)")->check(between<std::uint64_t>(0, UINT64_MAX));
    run->add_option("--trainee", o->trainee, "who sails, for the record; added to the roster when new");
    run->add_option("--type", o->type, "familiarise, train, assess, self-study or demo (train)")
        ->check(CLI::IsMember({"familiarise", "train", "assess", "self-study", "demo"}));
    run->add_option("--record", o->record, "recording file (else in the data folder)");
    run->add_option("--track", o->track, "track file, CSV");
    run->add_option("--track-hz", o->track_Hz, "rows a second in it (1)")->check(between(0.01, 50.0));
    run->add_option("--report", o->report, "report file, PDF");
    auto* resume = run->add_option("--resume", o->resume, "take up a recording that was broken off");
    run->add_flag("--json", o->json, "one JSON object on standard output");
    run->callback([=] {
        if (scenario->count() + resume->count() == 0) throw CLI::RequiredError("--scenario or --resume");
        if (resume->count()) tellUnused(*run);
    });
}

}  // namespace sagara::sim
