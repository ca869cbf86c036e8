#include "app/run/RunExercise.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "app/files/BuildScenario.h"
#include "app/files/Files.h"
#include "app/run/Console.h"
#include "app/run/Outputs.h"
#include "app/run/RecordingFile.h"
#include "app/run/RunFiling.h"
#include "app/run/TakeUp.h"
#include "core/exercise/OrderDocument.h"
#include "core/exercise/Replay.h"
#include "core/exercise/Session.h"
#include "db/PersonRepository.h"

namespace sagara::run {
namespace {

namespace fs = std::filesystem;

/// A run ready to go: new, or taken up again.
struct Prepared {
    std::shared_ptr<const core::World> world;
    core::State state;
    core::RecordingHeader header;
    std::vector<core::Event> events;  ///< of the part already sailed
    fs::path recording;
    std::optional<std::size_t> whole_bytes;  ///< of the recording to go on with
};

void sortByTime(std::vector<core::Command>& commands) {
    std::stable_sort(commands.begin(), commands.end(),
                     [](const auto& a, const auto& b) { return a.tick < b.tick; });
}

/// The order to end at the second asked for, if any.
void addEnd(const std::optional<double>& duration_s, std::vector<core::Command>& commands) {
    if (!duration_s) return;
    const double tick = std::ceil(*duration_s * core::kTicksPerSecond);
    commands.push_back({static_cast<std::int64_t>(tick), 0, core::FinishOrder{}});
    sortByTime(commands);
}

/// Commands known from the start: the pilot's, the file's and the end, by time.
std::optional<std::vector<core::Command>> plannedCommands(const core::World& world,
                                                          const RunOptions& options) {
    std::vector<core::Command> planned;
    if (options.pilot) planned.push_back({0, 0, core::PilotOrder{true}});
    addEnd(options.duration_s, planned);
    if (!options.commands) return planned;
    const auto text = files::readTextFile(*options.commands);
    if (!text) return tell(text.error().message), std::nullopt;
    auto loaded = core::loadCommands(options.commands->string(), *text, core::orderNames(world));
    if (!loaded) return tell(loaded.error().text()), std::nullopt;
    planned.insert(planned.end(), loaded->begin(), loaded->end());
    sortByTime(planned);
    return planned;
}

/// The trainee's name as the roster keeps it; empty when nobody is named.
std::optional<std::string> traineeName(const RunOptions& options) {
    if (options.trainee.empty()) return std::string();
    const auto name = db::personName(options.trainee);
    if (!name) return tell("--trainee: " + std::string(db::toText(name.error()))), std::nullopt;
    return name.value();
}

std::optional<Prepared> prepareNew(Store& store, const RunOptions& options) {
    const auto trainee = traineeName(options);
    if (!trainee) return std::nullopt;
    auto world = files::buildScenario(store, options.scenario, options.seed);
    if (!world) return tell(world.error()), std::nullopt;
    Prepared p;
    p.world = std::move(world).value();
    p.state = core::startState(*p.world, options.level);
    auto planned = plannedCommands(*p.world, options);
    if (!planned) return std::nullopt;
    p.header = newHeader(*p.world, options.level, options.type, *trainee);
    p.header.planned = std::move(*planned);
    p.recording =
        options.record ? fs::absolute(*options.record) : newRecordingPath(store, p.world->scenarioId);
    return p;
}

std::optional<Prepared> prepareResumed(const Store& store, const RunOptions& options) {
    auto found = takeUp(*options.resume, store.hulls());
    if (!found) return tell(found.error()), std::nullopt;
    TakenUp taken = std::move(found).value();
    tell(fmt::format(
        "{}: {}; taken up again at {}{}", options.resume->string(), taken.damage,
        clock(taken.state.time().seconds()),
        taken.lost_bytes ? fmt::format(", {} bytes after that are cut off", taken.lost_bytes) : ""));
    addEnd(options.duration_s, taken.header.planned);
    return Prepared{std::move(taken.world),  std::move(taken.state),        std::move(taken.header),
                    std::move(taken.events), fs::absolute(*options.resume), taken.whole_bytes};
}

/// Keeps the simulation's seconds to those of the wall, when asked to.
class Pace {
public:
    Pace(bool fast, const core::State& state)
        : m_fast(fast), m_begin_s(wallClock_s() - state.time().seconds()) {}
    void wait(const core::State& state) const {
        const double early_s = m_begin_s + state.time().seconds() - wallClock_s();
        if (!m_fast && early_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(early_s));
    }

private:
    bool m_fast;
    double m_begin_s;
};

std::string progressLine(const core::World& world, const core::State& state, double begin_s,
                         double beganAt_s) {
    const std::size_t done = state.assessment.currentTask, count = world.mission.tasks.size();
    const double pace = (state.time().seconds() - beganAt_s) / std::max(0.1, wallClock_s() - begin_s);
    return fmt::format("{}  {}  score {:.0f}  {:.0f} times real time", clock(state.time().seconds()),
                       done < count ? world.mission.tasks[done]->title() : "all tasks done",
                       core::scoreOf(state.assessment), pace);
}

/// The loop: until the exercise is over.
void sail(core::Session& session, bool fast, std::vector<core::Event>& events, TrackOutput& track) {
    const Pace pace(fast, session.state());
    Progress progress;
    const double begin_s = wallClock_s(), beganAt_s = session.state().time().seconds();
    track.add(session.state());
    while (!session.over()) {
        const auto now = session.step();
        events.insert(events.end(), now.begin(), now.end());
        track.add(session.state());
        pace.wait(session.state());
        if (progress.due()) progress.show(progressLine(session.world(), session.state(), begin_s, beganAt_s));
    }
}

void tellStopped(const core::World& world, const std::vector<core::Event>& events) {
    for (const core::Event& e : events) {
        if (e.kind != core::EventKind::Stopped) continue;
        tell(fmt::format("The exercise was stopped at {}: {} of {} ({}) is not a finite number.",
                         clock(e.time().seconds()), core::componentName(e.index), world.ships[e.ship]->name,
                         world.ships[e.ship]->vessel.id));
    }
}

/// Whether every file asked for has a folder to lie in: to be known before the run, not after it.
bool haveFolders(const RunOptions& options) {
    bool all = true;
    for (const auto& file : {options.record, options.track, options.report}) {
        if (!file) continue;
        const fs::path folder = fs::absolute(*file).parent_path();
        if (fs::is_directory(folder)) continue;
        tell(file->string() + " cannot be written: there is no folder " + folder.string());
        all = false;
    }
    return all;
}

}  // namespace

int runExercise(Store& store, const RunOptions& options) {
    RunFiling filing(store);
    if (!store.trouble().empty()) tell(store.trouble());
    for (const std::string& message : filing.fileNoted()) tell(message);
    if (!haveFolders(options)) return kBadRequest;
    auto prepared = options.resume ? prepareResumed(store, options) : prepareNew(store, options);
    if (!prepared) return kBadRequest;

    std::string trouble;
    auto file = RecordingFile::open(prepared->recording, prepared->whole_bytes.value_or(0), trouble);
    if (!file) return tell(trouble), kMachineFailed;
    core::RecordingWriter writer([&](std::span<const std::byte> bytes) { file->write(bytes); });
    const db::NewRun run = filing.newRun(prepared->header, *prepared->world, prepared->recording);
    bool sound = true;
    if (prepared->whole_bytes) {
        writer.goOn(prepared->state);
    } else {
        writer.begin(prepared->header, *prepared->world, prepared->state);
        (void)filing.begin(run);  // if this fails so will the end, which tells
    }

    TrackOutput track(*prepared->world, options.track, options.track_Hz);
    const double begin_s = wallClock_s();
    core::Session session(prepared->world, std::move(prepared->state), prepared->header.planned, &writer);
    sail(session, options.fast, prepared->events, track);
    writer.end(session.state());
    tellStopped(*prepared->world, prepared->events);

    const core::World& world = *prepared->world;
    RunSummary summary =
        summarise(world, world.mission, session.state().assessment, assessmentEvents(prepared->events));
    summary.simTime_s = session.state().time().seconds();
    summary.wallTime_s = wallClock_s() - begin_s;
    summary.stateHash = core::toHex(core::stateHash(session.state()));
    if (!file->trouble().empty()) sound = (tell(file->trouble()), false);
    const std::string unfiled = filing.end(run, summary, session.state().finished);
    if (!unfiled.empty()) tell(unfiled);
    sound = track.write() && sound;
    if (options.report) {
        const auto bytes = files::readBinaryFile(prepared->recording);
        const auto recording = bytes ? core::readRecording(*bytes)
                                     : core::Result<core::Recording, std::string>(bytes.error().message);
        if (!recording) tell(recording.error());
        sound =
            recording && writeReportOf(world, world.mission, *recording, summary, *options.report) && sound;
    }
    printSummary(summary, options.json);
    return sound ? kDone : kMachineFailed;
}

}  // namespace sagara::run
