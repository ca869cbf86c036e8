#include "core/exercise/Replay.h"

#include <algorithm>

#include "core/exercise/Advance.h"
#include "core/exercise/Observe.h"

namespace sagara::core {
namespace {

std::string second(std::int64_t tick) { return std::to_string(tick / kTicksPerSecond) + " s"; }

/// Commands of each tick in turn; they are stored in the order of their ticks.
class CommandsByTick {
public:
    CommandsByTick(const std::vector<Command>& commands, std::int64_t fromTick) : m_commands(commands) {
        while (m_next < m_commands.size() && m_commands[m_next].tick < fromTick) ++m_next;
    }
    std::span<const Command> at(std::int64_t tick) {
        const std::size_t first = m_next;
        while (m_next < m_commands.size() && m_commands[m_next].tick == tick) ++m_next;
        return std::span(m_commands).subspan(first, m_next - first);
    }

private:
    const std::vector<Command>& m_commands;
    std::size_t m_next = 0;
};

/// Whether a State fits the world: its lists have the world's lengths, so that advance may index them.
bool fits(const World& world, const State& state) {
    const bool sea = std::all_of(state.weather.sea.active.begin(), state.weather.sea.active.end(),
                                 [&](std::uint16_t i) { return i < world.waves.components().size(); });
    return state.ships.size() == world.ships.size() && state.added.size() <= kMostAddedTargets &&
           std::all_of(state.added.begin(), state.added.end(), isSound) &&
           state.targets.size() == world.targets.size() + state.added.size() &&
           state.fired.size() == world.events.size() &&
           state.assessment.tasks.size() == world.mission.tasks.size() &&
           state.assessment.criteria.size() == world.mission.criteria.size() && state.level >= 1 &&
           state.level <= kLevels && sea && state.weather.sea.active.size() <= kMostActiveComponents &&
           state.weather.sea.active.size() == state.weather.sea.amplitude_m.size();
}

std::optional<std::string> whyNot(const Recording& recording, std::int64_t tick) {
    if (!recording.sameBuild()) {
        return "the run was made by another build of Sagara (" + recording.header.buildId +
               ") and cannot be run again to the bit";
    }
    if (tick > recording.endTick) return "the recording ends at " + second(recording.endTick);
    return std::nullopt;
}

/// The State in which a run is replayed from its begin.
Result<State, std::string> firstState(const World& world, const Recording& recording) {
    return readState(world, recording.states.front());
}

}  // namespace

Result<std::shared_ptr<const World>, config::Problems> worldOf(const Recording& recording,
                                                               std::shared_ptr<SeaHulls> hulls) {
    ExerciseDocuments documents = recording.header.documents;
    documents.hulls = std::move(hulls);
    return buildWorld(documents, recording.header.seed);
}

Result<State, std::string> readState(const World& world, const Recording::StatePart& part) {
    auto state = part.version == kStateVersion ? fromBytes<State>(part.bytes) : std::nullopt;
    if (!state || !fits(world, *state)) return "the state at " + second(part.tick) + " cannot be read";
    return std::move(*state);
}

Result<State, std::string> stateAt(const World& world, const Recording& recording, std::int64_t tick) {
    if (const auto reason = whyNot(recording, tick)) return *reason;
    const Recording::StatePart* last = nullptr;
    for (const Recording::StatePart& part : recording.states) {
        if (part.tick <= tick) last = &part;
    }
    if (!last) return "there is no state at or before " + second(tick);
    auto loaded = readState(world, *last);
    if (!loaded) return loaded;
    State state = std::move(loaded).value();
    CommandsByTick commands(recording.commands, state.tick);
    while (state.tick < tick && !state.stopped) (void)advance(world, state, commands.at(state.tick));
    return state;
}

Result<State, std::string> replay(const World& world, const Recording& recording, std::int64_t untilTick,
                                  const AfterTick& after) {
    if (const auto reason = whyNot(recording, untilTick)) return *reason;
    auto loaded = firstState(world, recording);
    if (!loaded) return loaded;
    State state = std::move(loaded).value();
    CommandsByTick commands(recording.commands, state.tick);
    auto check = recording.states.begin() + 1;
    while (state.tick < untilTick && !state.stopped) {
        const auto given = commands.at(state.tick);
        const std::vector<Event> events = advance(world, state, given);
        after(state, given, events);
        if (check == recording.states.end() || check->tick != state.tick) continue;
        if (toBytes(state) != check->bytes)
            return "the run comes out otherwise from " + second(state.tick) + " on";
        ++check;
    }
    return state;
}

Grading gradeTrack(const Mission& mission, const RoutePath& path, const std::vector<TrackSample>& track,
                   const std::vector<Event>& events, std::int64_t untilTick) {
    Grading grading{startAssessment(mission), {}};
    auto event = events.begin();
    const auto takeEvents = [&](std::int64_t before) {
        for (; event != events.end() && event->tick < before; ++event) {
            const auto happening = event->ship == 0 ? happeningOf(*event) : std::nullopt;
            if (happening) assess(mission, grading.assessment, *happening, grading.events);
        }
    };
    std::optional<Observation> last;
    for (const TrackSample& sample : track) {
        if (sample.tick > untilTick) break;
        takeEvents(sample.tick);
        if (sample.tick == 0 || sample.ships.empty())
            continue;  // the first look is after the first fifth of a second
        last = sample.ships[0].observation;
        assess(mission, path, grading.assessment, *last, grading.events);
        if (!mission.tasks.empty() && allTasksDone(grading.assessment)) break;
    }
    if (last) closeAssessment(mission, grading.assessment, *last, grading.events);
    return grading;
}

Result<std::shared_ptr<const Mission>, config::Problems> loadRubric(const std::string& name,
                                                                    std::string_view text,
                                                                    const World& world) {
    config::Document document(name, text);
    if (!document.isKind("rubric", 1)) return document.problems();
    config::Reader in(document.root());
    in.text("document");
    in.integer("version", 1, 1);
    in.textOr("about", "");
    in.textOr("scenario", "");
    config::Reader mission(in.child("mission"));
    const MissionContext context{world.area, world.route, world.path, world.ships[0]->lineIds};
    auto read = std::make_shared<const Mission>(readMission(mission, context));
    in.rejectUnknownKeys();
    return document.finish(std::shared_ptr<const Mission>(std::move(read)));
}

}  // namespace sagara::core
