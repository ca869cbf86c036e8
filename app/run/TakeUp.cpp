#include "app/run/TakeUp.h"

#include "app/files/Files.h"
#include "core/exercise/RecordingBranch.h"
#include "core/exercise/Replay.h"

namespace sagara::run {
namespace {

/// To the end of what is there.
core::Result<TakenUp, std::string> takenUp(const std::string& name, std::shared_ptr<const core::World> world,
                                           const core::Recording& recording) {
    auto state = core::stateAt(*world, recording, recording.endTick);
    if (!state) return name + ": " + state.error();
    TakenUp taken;
    taken.track = recording.track(world->ships.size(), world->targets.size());
    taken.events = recording.events;
    taken.world = std::move(world);
    taken.state = std::move(state).value();
    taken.header = recording.header;
    taken.damage = recording.damage;
    taken.whole_bytes = recording.whole_bytes;
    return taken;
}

}  // namespace

core::Result<TakenUp, std::string> takeUp(const std::filesystem::path& path,
                                          std::shared_ptr<core::SeaHulls> hulls) {
    const auto bytes = files::readBinaryFile(path);
    if (!bytes) return bytes.error().message;
    const auto recording = core::readRecording(*bytes);
    if (!recording) return path.string() + ": " + recording.error();
    if (recording->end) return path.string() + ": this run has ended; there is nothing to take up again";
    auto world = core::worldOf(*recording, std::move(hulls));
    if (!world) return world.error().text();
    auto taken = takenUp(path.string(), std::move(world).value(), *recording);
    if (!taken) return taken;
    TakenUp all = std::move(taken).value();
    all.lost_bytes = bytes->size() - recording->whole_bytes;
    return all;
}

core::Result<SetBack, std::string> takeUpAt(std::shared_ptr<const core::World> world,
                                            const std::filesystem::path& path, std::int64_t tick) {
    const auto bytes = files::readBinaryFile(path);
    if (!bytes) return bytes.error().message;
    const auto whole = core::readRecording(*bytes);
    if (!whole) return path.string() + ": " + whole.error();
    auto kept = core::recordingUpTo(*bytes, whole->header, tick);
    if (!kept) return path.string() + ": " + kept.error();
    auto state = core::stateAt(*world, *whole, tick);
    if (!state) return path.string() + ": " + state.error();
    SetBack back;
    if (const auto recording = core::readRecording(*kept)) {  // of the very start there is nothing yet
        back.run.events = recording->events;
        back.run.track = recording->track(world->ships.size(), world->targets.size());
    }
    back.run.world = std::move(world);
    back.run.state = std::move(state).value();
    back.run.header = whole->header;
    back.recording = std::move(kept).value();
    return back;
}

}  // namespace sagara::run
