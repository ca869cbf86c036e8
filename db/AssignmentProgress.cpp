#include "db/AssignmentProgress.h"

#include <algorithm>
#include <map>

#include "db/sql/Words.h"

namespace sagara::db {
namespace {

constexpr Word<AssignmentState> kStates[] = {
    {AssignmentState::Open, "open"}, {AssignmentState::Done, "done"}, {AssignmentState::Late, "late"}};

bool fulfils(const RunRecord& run, const AssignmentRecord& assignment, PersonId person) {
    const NewAssignment& what = assignment.what;
    return run.start.person == person && run.status == RunStatus::Finished &&
           run.start.scenarioKey == what.scenarioKey && run.start.type == what.type &&
           run.start.level >= what.level && run.start.started.unix_s >= assignment.created.unix_s;
}

AssignmentState stateOf(bool done, core::Utc due, core::Utc now) {
    if (done) return AssignmentState::Done;
    return due.unix_s < now.unix_s ? AssignmentState::Late : AssignmentState::Open;
}

std::vector<PersonRecord> membersOf(const AssignmentRecord& assignment,
                                    const std::vector<PersonRecord>& people) {
    const auto& whom = assignment.what.forWhom;
    std::vector<PersonRecord> members;
    for (const PersonRecord& p : people) {
        const bool alone = std::holds_alternative<PersonId>(whom) && std::get<PersonId>(whom) == p.id;
        const bool inClass =
            std::holds_alternative<ClassId>(whom) && !p.retired && p.schoolClass == std::get<ClassId>(whom);
        if (alone || inClass) members.push_back(p);
    }
    return members;
}

using RunsByPerson = std::map<PersonId, std::vector<RunRecord>>;

AssignmentProgress progressOf(const AssignmentRecord& assignment, const std::vector<PersonRecord>& people,
                              const RunsByPerson& finished, core::Utc now) {
    static const std::vector<RunRecord> kNone;
    AssignmentProgress progress;
    progress.assignment = assignment;
    for (PersonRecord& p : membersOf(assignment, people)) {
        const auto runs = finished.find(p.id);
        const auto done = firstFulfilled(assignment, p.id, runs == finished.end() ? kNone : runs->second);
        const AssignmentState state = stateOf(done.has_value(), assignment.what.due, now);
        progress.members.push_back({std::move(p), done, state});
    }
    const bool all =
        !progress.members.empty() && progress.done() == static_cast<int>(progress.members.size());
    progress.state =
        progress.members.empty() ? AssignmentState::Open : stateOf(all, assignment.what.due, now);
    return progress;
}

}  // namespace

std::string_view toText(AssignmentState state) { return wordOf(kStates, state); }

int AssignmentProgress::done() const {
    return static_cast<int>(std::count_if(members.begin(), members.end(),
                                          [](const MemberProgress& m) { return m.done.has_value(); }));
}

std::optional<core::Utc> firstFulfilled(const AssignmentRecord& assignment, PersonId person,
                                        const std::vector<RunRecord>& finished) {
    std::optional<core::Utc> first;
    for (const RunRecord& run : finished) {
        if (!fulfils(run, assignment, person) || !run.finished) continue;
        if (!first || run.finished->unix_s < first->unix_s) first = run.finished;
    }
    return first;
}

std::vector<AssignmentProgress> assignmentProgress(Database& db, core::Utc now) {
    const std::vector<PersonRecord> people = PersonRepository(db).all();
    const std::vector<AssignmentRecord> assignments = AssignmentRepository(db).list();
    std::vector<AssignmentProgress> all;
    if (assignments.empty()) return all;
    const auto oldest =
        std::min_element(assignments.begin(), assignments.end(),
                         [](const auto& a, const auto& b) { return a.created.unix_s < b.created.unix_s; });
    RunsByPerson finished;
    for (RunRecord& run : RunRepository(db).finished(oldest->created))
        finished[*run.start.person].push_back(std::move(run));
    for (const AssignmentRecord& a : assignments) all.push_back(progressOf(a, people, finished, now));
    return all;
}

}  // namespace sagara::db
