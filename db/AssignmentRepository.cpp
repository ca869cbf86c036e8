#include "db/AssignmentRepository.h"

#include "db/AssignmentProgress.h"
#include "db/Database.h"
#include "db/sql/Query.h"
#include "db/sql/Words.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;

constexpr Word<AssignError> kErrors[] = {
    {AssignError::ScenarioEmpty, "no mission is chosen, expected one of the list"},
    {AssignError::DueInThePast, "the due date is in the past, expected a later one"},
    {AssignError::LevelUnknown, "there is no such level, expected 1 to 5"},
    {AssignError::TypeUnknown,
     "such a run cannot be assigned, expected familiarise, train, assess or self-study"}};

const auto kSelect =
    u"SELECT id, scenario_key, scenario_name, person_id, class_id, due_utc, type, level, assigned_by, "
    "created_utc, withdrawn_utc FROM assignment "_s;
const auto kOrder = u"ORDER BY due_utc, id"_s;

template <Id T>
std::optional<T> readId(const Query& row, const QString& column) {
    if (row.isNull(column)) return std::nullopt;
    return row.id<T>(column);
}

std::variant<PersonId, ClassId> readForWhom(const Query& row) {
    if (row.isNull(u"person_id"_s)) return row.id<ClassId>(u"class_id"_s);
    return row.id<PersonId>(u"person_id"_s);
}

AssignmentRecord readAssignment(const Query& row) {
    return {.id = row.id<AssignmentId>(u"id"_s),
            .what = {.scenarioKey = row.text(u"scenario_key"_s),
                     .scenarioName = row.text(u"scenario_name"_s),
                     .forWhom = readForWhom(row),
                     .due = row.utc(u"due_utc"_s),
                     .type = row.word(u"type"_s, parseRunType),
                     .level = static_cast<int>(row.integer(u"level"_s)),
                     .assignedBy = readId<PersonId>(row, u"assigned_by"_s)},
            .created = row.utc(u"created_utc"_s),
            .withdrawn =
                row.isNull(u"withdrawn_utc"_s) ? std::nullopt : std::optional(row.utc(u"withdrawn_utc"_s))};
}

std::vector<AssignmentRecord> readAll(Query row) {
    std::vector<AssignmentRecord> all;
    while (row.next()) all.push_back(readAssignment(row));
    return all;
}

template <Id T>
std::optional<T> only(const std::variant<PersonId, ClassId>& whom) {
    const T* const id = std::get_if<T>(&whom);
    return id ? std::optional(*id) : std::nullopt;
}

}  // namespace

std::string_view toText(AssignError error) { return wordOf(kErrors, error); }

core::Result<AssignmentId, AssignError> AssignmentRepository::add(const NewAssignment& a, core::Utc now) {
    if (a.scenarioKey.empty()) return AssignError::ScenarioEmpty;
    if (a.due.unix_s <= now.unix_s) return AssignError::DueInThePast;
    if (a.level < 1 || a.level > 5) return AssignError::LevelUnknown;
    if (a.type == RunType::Demo) return AssignError::TypeUnknown;
    const Query insert(
        m_db.connection(),
        u"INSERT INTO assignment (scenario_key, scenario_name, person_id, class_id, due_utc, type, level, "
        "assigned_by, created_utc) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"_s,
        a.scenarioKey, a.scenarioName, only<PersonId>(a.forWhom), only<ClassId>(a.forWhom), a.due,
        toText(a.type), a.level, a.assignedBy, now);
    return AssignmentId{insert.newId()};
}

bool AssignmentRepository::withdraw(AssignmentId id, core::Utc now) {
    return execute(m_db.connection(),
                   u"UPDATE assignment SET withdrawn_utc = ? WHERE id = ? AND withdrawn_utc IS NULL"_s, now,
                   id) == 1;
}

std::optional<AssignmentRecord> AssignmentRepository::find(AssignmentId id) const {
    Query row(m_db.connection(), kSelect + u"WHERE id = ?"_s, id);
    if (!row.next()) return std::nullopt;
    return readAssignment(row);
}

std::vector<AssignmentRecord> AssignmentRepository::list() const {
    return readAll(Query(m_db.connection(), kSelect + kOrder));
}

std::vector<AssignmentRecord> AssignmentRepository::of(PersonId person) const {
    const auto record = PersonRepository(m_db).find(person);
    const ClassId kNoClass{0};  // ids begin at 1
    const ClassId schoolClass = record ? record->schoolClass.value_or(kNoClass) : kNoClass;
    return readAll(
        Query(m_db.connection(),
              kSelect + u"WHERE withdrawn_utc IS NULL AND (person_id = ? OR class_id = ?) "_s + kOrder,
              person, schoolClass));
}

std::vector<AssignmentRecord> AssignmentRepository::openFor(PersonId person) const {
    const std::vector<RunRecord> runs = RunRepository(m_db).finishedBy(person);
    std::vector<AssignmentRecord> open = of(person);
    std::erase_if(open, [&](const AssignmentRecord& a) { return firstFulfilled(a, person, runs); });
    return open;
}

}  // namespace sagara::db
