#include "core/exercise/Advance.h"

#include <algorithm>
#include <cmath>

#include "core/base/Archive.h"
#include "core/exercise/ApplyOrder.h"
#include "core/exercise/MoveShip.h"
#include "core/exercise/MoveTargets.h"
#include "core/exercise/Observe.h"

namespace sagara::core {
namespace {

constexpr auto kGradeEvery_ticks = static_cast<std::int64_t>(kObservedEvery_s / kTick_s + 0.5);
constexpr std::int64_t kAfterFailure_ticks = 10 * kTicksPerSecond;  // what follows a failure is still graded

void fireDueEvents(const World& world, State& state, std::vector<Event>& events) {
    for (std::uint32_t i = 0; i < world.events.size(); ++i) {
        if (state.fired[i]) continue;
        const EventTrigger& t = world.events[i].trigger;
        const bool due = t.time_s && state.time().seconds() >= *t.time_s;
        const bool inZone = t.zone && distance(state.ships[0].motion.position(), t.centre) <= t.radius_m;
        if (due || inZone) fireEvent(world, state, i, events);
    }
}

Event eventOf(const State& state, const AssessmentEvent& a) {
    Event e;
    e.tick = a.deduction.time.us / kTick_us;
    e.index = static_cast<std::int32_t>(a.index);
    e.place = a.deduction.place;
    e.value = a.deduction.value;
    e.limit = a.deduction.limit;
    e.points = a.deduction.points;
    switch (a.kind) {
        case AssessmentEvent::Kind::TaskDone:
            e.kind = EventKind::TaskDone;
            break;
        case AssessmentEvent::Kind::Deduction:
            e.kind = EventKind::Deduction;
            break;
        case AssessmentEvent::Kind::Failed:
            e.kind = EventKind::MissionFailed;
            e.tick = state.tick;
            break;
    }
    return e;
}

/// Grades what has happened in this tick and, every kObservedEvery_s, what is.
void grade(const World& world, State& state, std::vector<Event>& events) {
    if (state.assessment.closed || world.mission.tasks.empty()) return;
    std::vector<AssessmentEvent> found;
    for (const Event& event : events) {
        const auto happening = event.ship == 0 ? happeningOf(event) : std::nullopt;
        if (happening) assess(world.mission, state.assessment, *happening, found);
    }
    if (state.tick % kGradeEvery_ticks == 0) {
        assess(world.mission, world.path, state.assessment, observe(world, state, 0), found);
    }
    for (const AssessmentEvent& a : found) events.push_back(eventOf(state, a));
    if (state.assessment.failed && state.failedTick < 0) state.failedTick = state.tick;
}

void finishWhenOver(const World& world, State& state, std::vector<Event>& events) {
    if (state.assessment.closed) return;
    const bool failed = state.failedTick >= 0 && state.tick >= state.failedTick + kAfterFailure_ticks;
    const bool done = !world.mission.tasks.empty() && allTasksDone(state.assessment);
    if (!state.finished && !failed && !done && state.time().seconds() < world.longest_s) return;
    state.finished = true;
    std::vector<AssessmentEvent> found;
    closeAssessment(world.mission, state.assessment, observe(world, state, 0), found);
    for (const AssessmentEvent& a : found) events.push_back(eventOf(state, a));
    Event e;
    e.tick = state.tick;
    e.kind = EventKind::Finished;
    e.place = state.ships[0].motion.position();
    events.push_back(e);
}

}  // namespace

State startState(const World& world, int level) {
    State state;
    state.level = std::clamp(level, 1, kLevels);
    state.weather = startWeather(world.weather, world.level(state.level), world.waves, world.sea);
    for (const auto& ship : world.ships) state.ships.push_back(startOf(*ship));
    for (const TargetLayout& layout : world.targets) state.targets.push_back(startOf(layout));
    state.fired.assign(world.events.size(), 0);
    state.assessment = startAssessment(world.mission);
    std::vector<Event> ignored;  // who is there at the start has not appeared
    bringTargets(world, state, ignored);
    for (std::size_t i = 0; i < state.ships.size(); ++i) {
        const double tide_m = world.tide.height_m({});
        state.ships[i].underKeel_m =
            underKeel(world.area, world.ships[i]->keel, state.ships[i].motion, tide_m).clearance_m;
    }
    return state;
}

std::uint64_t stateHash(const State& state) { return archiveHash(state); }

std::vector<Event> advance(const World& world, State& state, std::span<const Command> commands) {
    std::vector<Event> events;
    if (state.stopped) return events;
    DeckWatch before(state);
    for (const Command& command : commands) applyOrder(world, state, command.ship, command.order, events);
    fireDueEvents(world, state, events);
    runWeather(state.weather, world.waves, state.tick, world.sea);

    TickEnvironment environment(world, state);
    moveTargets(world, state, environment.water, kTick_s);
    for (std::size_t i = 0; i < state.ships.size() && !state.stopped; ++i)
        moveShip(world, state, i, environment, events);
    before.report(world, state, events);
    ++state.tick;
    if (state.stopped) return events;
    grade(world, state, events);
    finishWhenOver(world, state, events);
    return events;
}

}  // namespace sagara::core
