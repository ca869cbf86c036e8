#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/Result.h"
#include "core/base/Utc.h"
#include "db/ClassRepository.h"
#include "db/PersonRepository.h"
#include "db/RunRepository.h"

namespace sagara::db {

class Database;

enum class AssignmentId : std::int64_t {};

struct NewAssignment {
    std::string scenarioKey;
    std::string scenarioName;                 ///< as it is called now
    std::variant<PersonId, ClassId> forWhom;  ///< a class: everybody who is in it
    core::Utc due;
    RunType type = RunType::Train;  ///< not Demo
    int level = 3;                  ///< 1 to 5, the least that counts
    std::optional<PersonId> assignedBy;
};

struct AssignmentRecord {
    AssignmentId id{};
    NewAssignment what;
    core::Utc created;
    std::optional<core::Utc> withdrawn;
};

enum class AssignError { ScenarioEmpty, DueInThePast, LevelUnknown, TypeUnknown };
/// For a person at the keyboard: what is wrong and what is accepted.
std::string_view toText(AssignError error);

/// Missions that people or classes are to sail by a date. All SQL about table `assignment` is in this class's
/// .cpp file. How far they are: AssignmentProgress.h.
class AssignmentRepository final {
public:
    explicit AssignmentRepository(Database& db) : m_db(db) {}

    core::Result<AssignmentId, AssignError> add(const NewAssignment& assignment, core::Utc now);
    /// False, and nothing changed, when it is not there or withdrawn already.
    bool withdraw(AssignmentId id, core::Utc now);
    std::optional<AssignmentRecord> find(AssignmentId id) const;
    std::vector<AssignmentRecord> list() const;  ///< withdrawn ones too; the earliest due first

    /// What this person has been given, alone or with the class, and was not withdrawn; the earliest due
    /// first.
    std::vector<AssignmentRecord> of(PersonId person) const;
    /// Of those, what no run has fulfilled yet. Late is what has `what.due` behind it.
    std::vector<AssignmentRecord> openFor(PersonId person) const;

private:
    Database& m_db;  ///< outlives every repository
};

}  // namespace sagara::db
