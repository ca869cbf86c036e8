#pragma once

#include <optional>
#include <vector>

#include "db/AssignmentRepository.h"

namespace sagara::db {

enum class AssignmentState { Open, Done, Late };
std::string_view toText(AssignmentState state);

/// One of those who are to sail it.
struct MemberProgress {
    PersonRecord person;
    std::optional<core::Utc> done;  ///< end of the first run that fulfilled it
    AssignmentState state = AssignmentState::Open;
};

struct AssignmentProgress {
    AssignmentRecord assignment;
    std::vector<MemberProgress> members;  ///< one person, or those in the class now
    /// Done when all have; Late when somebody has not and the date is behind; a class without people is open.
    AssignmentState state = AssignmentState::Open;
    int done() const;
};

/// When this person first fulfilled an assignment: sailed its scenario to the end, as its type, at its level
/// or a harder one, begun after it was given. Passed or not: that is the grade's business.
std::optional<core::Utc> firstFulfilled(const AssignmentRecord& assignment, PersonId person,
                                        const std::vector<RunRecord>& finished);

/// Every assignment and how far it is, the earliest due first.
std::vector<AssignmentProgress> assignmentProgress(Database& db, core::Utc now);

}  // namespace sagara::db
