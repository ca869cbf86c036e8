#include "Between.h"
#include "Commands.h"
#include "app/run/RunExercise.h"

namespace sagara::sim {

void addReplay(Commands& commands) {
    auto o = std::make_shared<run::ReplayOptions>();
    CLI::App* replay =
        commands.add("replay", "run a recording again to the bit, or grade it by another rubric",
                     [o] { return run::replayRecording(*o); });
    replay->add_option("recording", o->recording, "recording file")->required();
    replay->add_option("--until-s", o->until_s, "stop at this second")->check(between(0.0, kLongest_s));
    replay->add_option("--track", o->track, "track file, CSV");
    replay->add_option("--track-hz", o->track_Hz, "rows a second in it (1)")->check(between(0.01, 50.0));
    replay->add_option("--rubric", o->rubric, "grade by the mission of this rubric file");
    replay->add_option("--report", o->report, "report file, PDF");
    replay->add_flag("--json", o->json, "one JSON object on standard output");
}

}  // namespace sagara::sim
