#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/Result.h"
#include "core/base/Utc.h"
#include "db/RunRepository.h"

namespace sagara::db {

class Database;

/// The assessor's own result in place of the automatic one.
struct Overrule {
    double score = 0.0;  ///< 0 to 100
    bool passed = false;
    std::string reason;
    friend bool operator==(const Overrule&, const Overrule&) = default;
};

struct SignOff {
    PersonId by{};
    std::string name;  ///< as it was then
    core::Utc at;
    friend bool operator==(const SignOff&, const SignOff&) = default;
};

struct Assessment {
    std::string comment;
    std::optional<Overrule> overrule;
    friend bool operator==(const Assessment&, const Assessment&) = default;
};

struct AssessmentRecord {
    Assessment assessment;
    core::Utc changed;
    std::optional<SignOff> signedOff;  ///< nothing changes after that, the grade included
};

enum class AssessError {
    SignedAlready,
    ReasonEmpty,
    ScoreOutOfRange,
    CommentTooLong,
    RunNotEnded,
    NotATrainer,
    OwnRun
};
/// For a person at the keyboard: what is wrong and what is accepted.
std::string_view toText(AssessError error);

/// What the assessor says of a run, at most one each. All SQL about table `assessment` is in this class's
/// .cpp file; the schema itself refuses changes after the sign-off.
class AssessmentRepository final {
public:
    explicit AssessmentRepository(Database& db) : m_db(db) {}

    std::optional<AssessmentRecord> find(RunId run) const;
    /// The reason for overruling (up to 1000 characters) must be given; the comment may hold 4000.
    core::Result<RunId, AssessError> put(RunId run, const Assessment& assessment, core::Utc now);
    /// Once, by a trainer or an admin in use, for a run that has ended and was somebody else's.
    core::Result<SignOff, AssessError> sign(RunId run, PersonId by, core::Utc now);

private:
    Database& m_db;  ///< outlives every repository
};

}  // namespace sagara::db
