#include <cmath>

#include "app/files/Files.h"
#include "app/run/Console.h"
#include "app/run/GradeRecording.h"
#include "app/run/Outputs.h"
#include "app/run/RunExercise.h"

namespace sagara::run {
namespace {

/// The rubric asked for, or null; false when it cannot be used.
bool readRubric(const ReplayOptions& options, const core::World& world,
                std::shared_ptr<const core::Mission>& rubric) {
    if (!options.rubric) return true;
    const auto text = files::readTextFile(*options.rubric);
    if (!text) return tell(text.error().message), false;
    auto loaded = core::loadRubric(options.rubric->string(), *text, world);
    if (!loaded) return tell(loaded.error().text()), false;
    rubric = std::move(loaded).value();
    return true;
}

}  // namespace

int replayRecording(const ReplayOptions& options) {
    const std::string name = options.recording.string();
    const auto bytes = files::readBinaryFile(options.recording);
    if (!bytes) return tell(bytes.error().message), kBadRequest;
    const auto recording = core::readRecording(*bytes);
    if (!recording) return tell(name + ": " + recording.error()), kBadRequest;
    if (!recording->damage.empty()) {
        tell(name + ": " + recording->damage + "; what is whole, up to " +
             clock(core::timeOfTick(recording->endTick).seconds()) + ", is used");
    }
    const auto built = core::worldOf(*recording);
    if (!built) return tell(built.error().text()), kBadRequest;
    const core::World& world = **built;
    std::shared_ptr<const core::Mission> rubric;
    if (!readRubric(options, world, rubric)) return kBadRequest;

    const auto until =
        options.until_s ? std::llround(*options.until_s * core::kTicksPerSecond) : recording->endTick;
    TrackOutput track(world, options.track, options.track_Hz);
    const double begin_s = wallClock_s();
    if (recording->sameBuild()) {
        if (const auto first = core::stateAt(world, *recording, recording->states.front().tick))
            track.add(*first);
    }
    RunSummary summary = gradeRecording(world, *recording, until, rubric.get(),
                                        [&](const core::State& state, std::span<const core::Command>,
                                            std::span<const core::Event>) { track.add(state); });
    summary.wallTime_s = wallClock_s() - begin_s;
    if (!recording->sameBuild()) {
        for (const core::TrackSample& sample : recording->track(world.ships.size(), world.targets.size())) {
            if (sample.tick <= until) track.add(sample);
        }
    }
    bool sound = track.write();
    if (options.report)
        sound =
            writeReportOf(world, rubric ? *rubric : world.mission, *recording, summary, *options.report) &&
            sound;
    printSummary(summary, options.json);
    return sound ? kDone : kMachineFailed;
}

}  // namespace sagara::run
