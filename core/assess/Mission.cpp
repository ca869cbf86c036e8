#include "core/assess/Mission.h"

#include <algorithm>

namespace sagara::core {
namespace {

/// How far back and on the route the ship is looked for: she may turn back a little, and must not skip to a
/// later leg that runs past an earlier one.
constexpr double kBehind_m = 100.0, kAhead_m = 400.0;

bool isOver(const Assessment& state) { return state.closed; }

/// Hands deductions on as events, with the failing ones after them.
void report(const Mission& mission, Assessment& state, std::uint32_t index,
            const std::vector<Deduction>& deductions, std::vector<AssessmentEvent>& out) {
    for (const Deduction& d : deductions) out.push_back({AssessmentEvent::Kind::Deduction, index, d});
    if (state.failed || !mission.criteria[index]->terms().fails || !state.criteria[index].broken) return;
    state.failed = true;
    const Deduction& why = deductions.empty() ? state.criteria[index].worst : deductions.back();
    out.push_back({AssessmentEvent::Kind::Failed, index, why});
}

template <typename Item, typename Read>
std::vector<std::unique_ptr<const Item>> readItems(config::Reader& in, const char* key,
                                                   const MissionContext& context, Read&& read,
                                                   std::string (*idOf)(const Item&)) {
    std::vector<std::unique_ptr<const Item>> items;
    for (const config::Node& node : in.list(key)) {
        auto item = read(node, context);
        if (!item) continue;
        const std::string id = idOf(*item);
        if (std::any_of(items.begin(), items.end(), [&](const auto& other) { return idOf(*other) == id; })) {
            node.problem("has the id \"" + id + "\" again", "each id once");
        }
        items.push_back(std::move(item));
    }
    return items;
}

}  // namespace

Mission readMission(config::Reader& in, const MissionContext& context) {
    Mission m;
    m.objective = in.text("objective");
    m.competenceCode = in.text("competenceCode");
    m.briefing = in.text("briefing");
    m.passScore = in.number("passScore", {0.0, 100.0, "points"});
    m.tasks = readItems<Task>(in, "tasks", context, readTask, [](const Task& task) { return task.id(); });
    m.criteria = readItems<Criterion>(in, "criteria", context, readCriterion,
                                      [](const Criterion& criterion) { return criterion.terms().id; });
    in.rejectUnknownKeys();
    return m;
}

Assessment startAssessment(const Mission& mission) {
    Assessment state;
    state.tasks.resize(mission.tasks.size());
    state.criteria.resize(mission.criteria.size());
    return state;
}

void assess(const Mission& mission, const RoutePath& path, Assessment& state, const Observation& now,
            std::vector<AssessmentEvent>& out) {
    if (isOver(state)) return;
    follow(path, now.position, state.route);
    std::vector<Deduction> deductions;
    for (std::uint32_t i = 0; i < state.criteria.size(); ++i) {
        deductions.clear();
        mission.criteria[i]->observe(now, state.route, state.criteria[i], deductions);
        report(mission, state, i, deductions, out);
    }
    if (state.currentTask < state.tasks.size()) {
        TaskMemory& memory = state.tasks[state.currentTask];
        if (!mission.tasks[state.currentTask]->step(now, memory)) return;
        memory.done = true;
        memory.doneAt = now.time;
        out.push_back(
            {AssessmentEvent::Kind::TaskDone, state.currentTask, {now.time, now.position, 0.0, 0.0, 0.0}});
        ++state.currentTask;
    }
}

void assess(const Mission& mission, Assessment& state, const Happening& happening,
            std::vector<AssessmentEvent>& out) {
    if (isOver(state)) return;
    std::vector<Deduction> deductions;
    for (std::uint32_t i = 0; i < state.criteria.size(); ++i) {
        deductions.clear();
        mission.criteria[i]->happened(happening, state.criteria[i], deductions);
        report(mission, state, i, deductions, out);
    }
}

void follow(const RoutePath& path, NorthEast position, RouteProgress& progress) {
    if (path.length_m() == 0.0) return;
    const RoutePath::Place here = path.nearest(position, progress.along_m, kBehind_m, kAhead_m);
    progress = {here.along_m, here.offTrack_m, static_cast<std::uint32_t>(here.leg)};
}

Limits limitsAt(const Mission& mission, const Observation& now, const RouteProgress& route) {
    Limits limits;
    for (const auto& criterion : mission.criteria) criterion->narrow(limits, now, route);
    return limits;
}

void closeAssessment(const Mission& mission, Assessment& state, const Observation& last,
                     std::vector<AssessmentEvent>& out) {
    if (isOver(state)) return;
    for (std::uint32_t i = 0; i < state.criteria.size(); ++i) {
        std::vector<Deduction> deductions;
        mission.criteria[i]->close(last.time, state.criteria[i], deductions);
        report(mission, state, i, deductions, out);
    }
    state.closed = true;
}

double scoreOf(const Assessment& state) {
    double lost = 0.0;
    for (const CriterionMemory& memory : state.criteria) lost += memory.lost;
    return std::max(0.0, 100.0 - lost);
}

bool allTasksDone(const Assessment& state) { return state.currentTask >= state.tasks.size(); }

bool passed(const Mission& mission, const Assessment& state) {
    return allTasksDone(state) && !state.failed && scoreOf(state) >= mission.passScore;
}

}  // namespace sagara::core
