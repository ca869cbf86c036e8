#include "app/run/RunSummary.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace sagara::run {
namespace {

using core::AssessmentEvent;
using Json = nlohmann::ordered_json;

/// Not more digits than mean something. Divides by a power of ten, so that the result is the double nearest
/// to those digits and prints as them.
double rounded(double value, double perUnit) { return std::round(value * perUnit) / perUnit; }

std::string whyNotPassed(const core::Mission& mission, const core::Assessment& assessment,
                         const RunSummary& summary) {
    for (std::size_t i = 0; i < assessment.criteria.size(); ++i) {
        const core::Criterion::Terms& terms = mission.criteria[i]->terms();
        if (terms.fails && assessment.criteria[i].broken) return "failed: " + terms.title;
    }
    if (!core::allTasksDone(assessment)) return "not done: " + mission.tasks[assessment.currentTask]->title();
    if (summary.score < mission.passScore)
        return fmt::format("score {:.0f}, {:.0f} needed", summary.score, mission.passScore);
    return {};
}

Json taskArray(const RunSummary& summary) {
    Json array = Json::array();
    for (const RunSummary::Task& t : summary.tasks) {
        array.push_back({{"id", t.id},
                         {"done", t.done},
                         {"time_s", t.done ? Json(rounded(t.time_s, 100.0)) : Json(nullptr)}});
    }
    return array;
}

Json lossArray(const RunSummary& summary) {
    Json array = Json::array();
    for (const RunSummary::Loss& l : summary.losses) {
        array.push_back({{"id", l.id},
                         {"title", l.title},
                         {"time_s", rounded(l.time_s, 100.0)},
                         {"lat_deg", rounded(l.geo.lat_deg, 1e6)},
                         {"lon_deg", rounded(l.geo.lon_deg, 1e6)},
                         {"value", rounded(l.value, 1000.0)},
                         {"limit", rounded(l.limit, 1000.0)},
                         {"unit", l.unit},
                         {"points", rounded(l.points, 100.0)},
                         {"fails", l.fails}});
    }
    return array;
}

RunSummary::Loss lossOf(const core::World& world, const core::Mission& mission,
                        const AssessmentEvent& event) {
    const core::Criterion& criterion = *mission.criteria[event.index];
    const core::Display display = criterion.display();
    const core::Deduction& d = event.deduction;
    RunSummary::Loss loss;
    loss.id = criterion.terms().id;
    loss.title = criterion.terms().title;
    loss.quantity = display.quantity;
    loss.unit = display.unit;
    loss.time_s = d.time.seconds();
    loss.place = d.place;
    loss.geo = world.area.frame.toGeo(d.place);
    loss.value = d.value / display.perUnit;
    loss.limit = d.limit / display.perUnit;
    loss.points = d.points;
    loss.fails = criterion.terms().fails;
    return loss;
}

}  // namespace

std::string clock(double time_s) {
    const auto whole = static_cast<long>(time_s);
    if (whole < 3600) return fmt::format("{:02}:{:02}", whole / 60, whole % 60);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::vector<AssessmentEvent> assessmentEvents(const std::vector<core::Event>& events) {
    std::vector<AssessmentEvent> reported;
    for (const core::Event& e : events) {
        AssessmentEvent a;
        switch (e.kind) {
            case core::EventKind::TaskDone:
                a.kind = AssessmentEvent::Kind::TaskDone;
                break;
            case core::EventKind::Deduction:
                a.kind = AssessmentEvent::Kind::Deduction;
                break;
            case core::EventKind::MissionFailed:
                a.kind = AssessmentEvent::Kind::Failed;
                break;
            default:
                continue;
        }
        a.index = static_cast<std::uint32_t>(e.index);
        a.deduction = {e.time(), e.place, e.value, e.limit, e.points};
        reported.push_back(a);
    }
    return reported;
}

RunSummary summarise(const core::World& world, const core::Mission& mission,
                     const core::Assessment& assessment, const std::vector<AssessmentEvent>& reported) {
    RunSummary s;
    s.scenario = world.scenarioId;
    s.score = core::scoreOf(assessment);
    s.passed = core::passed(mission, assessment);
    for (std::size_t i = 0; i < mission.tasks.size(); ++i) {
        const core::TaskMemory& memory = assessment.tasks[i];
        s.tasks.push_back(
            {mission.tasks[i]->id(), mission.tasks[i]->title(), memory.done, memory.doneAt.seconds()});
    }
    for (const AssessmentEvent& event : reported) {
        if (event.kind == AssessmentEvent::Kind::Deduction && event.index < mission.criteria.size()) {
            s.losses.push_back(lossOf(world, mission, event));
        }
    }
    std::stable_sort(s.losses.begin(), s.losses.end(),
                     [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
    if (!s.passed) s.whyNot = whyNotPassed(mission, assessment, s);
    return s;
}

std::string tasksJson(const RunSummary& summary) {
    Json array = taskArray(summary);
    for (std::size_t i = 0; i < summary.tasks.size(); ++i) array[i]["title"] = summary.tasks[i].title;
    return array.dump();
}
std::string deductionsJson(const RunSummary& summary) { return lossArray(summary).dump(); }

std::string toJson(const RunSummary& s) {
    const Json json{{"scenario", s.scenario},
                    {"passed", s.passed},
                    {"score", rounded(s.score, 100.0)},
                    {"tasks", taskArray(s)},
                    {"deductions", lossArray(s)},
                    {"sim_time_s", rounded(s.simTime_s, 1000.0)},
                    {"wall_time_s", rounded(s.wallTime_s, 1000.0)},
                    {"state_hash", s.stateHash},
                    {"why_not", s.whyNot},
                    {"graded_from", s.gradedFrom}};
    return json.dump();
}

std::string toText(const RunSummary& s) {
    std::string text = fmt::format("{}: {}, score {:.0f} of 100 (automatic score, advisory)\n", s.scenario,
                                   s.passed ? "passed" : "not passed, " + s.whyNot, s.score);
    for (const RunSummary::Task& t : s.tasks) {
        text += fmt::format("  {:>7}  {}\n", t.done ? clock(t.time_s) : "-", t.title);
    }
    if (s.losses.empty()) text += "  no points were deducted\n";
    for (const RunSummary::Loss& l : s.losses) {
        text += fmt::format("  {:>7}  -{:<3.0f} {}: {} {:.2f} {}, limit {:.2f}\n", clock(l.time_s), l.points,
                            l.title, l.quantity, l.value, l.unit, l.limit);
    }
    text += fmt::format("  sailed {} in {:.1f} s", clock(s.simTime_s), s.wallTime_s);
    if (s.wallTime_s > 0.0) text += fmt::format(", {:.0f} times real time", s.simTime_s / s.wallTime_s);
    if (!s.gradedFrom.empty()) text += "\n  graded from " + s.gradedFrom;
    return text + "\nstate-hash: " + s.stateHash + "\n";
}

}  // namespace sagara::run
