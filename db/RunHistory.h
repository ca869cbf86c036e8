#pragma once

#include <optional>
#include <string>
#include <vector>

#include "db/ClassRepository.h"
#include "db/RunRepository.h"

namespace sagara::db {

class Database;

/// A score and whether it is a pass; the automatic one, or the assessor's.
struct ScoreAndPass {
    double score = 0.0;
    bool passed = false;
    friend bool operator==(const ScoreAndPass&, const ScoreAndPass&) = default;
};

/// One line of the school's list of runs.
struct RunLine {
    RunId run{};
    std::optional<PersonId> person;
    std::string personName;  ///< as it is now; empty: nobody named
    std::string className;   ///< of the person, now
    std::string scenarioKey;
    std::string scenarioName;
    RunType type = RunType::Train;
    int level = 1;
    core::Utc started;
    RunStatus status = RunStatus::Running;
    core::SimTime simTime;
    std::string recordingFile;
    std::optional<ScoreAndPass> automatic;  ///< advisory
    std::optional<ScoreAndPass> overruled;  ///< the assessor's
    std::string signedBy;                   ///< empty: not signed off
    std::optional<core::Utc> signedAt;

    const std::optional<ScoreAndPass>& valid() const { return overruled ? overruled : automatic; }
};

struct RunFilter {
    std::optional<PersonId> person;
    std::optional<ClassId> schoolClass;
    std::string scenarioKey;  ///< empty: any
    std::optional<RunType> type;
};

/// Runs with who sailed them and what came of them. Reads only: the view `run_history`, whose SQL is all in
/// this class's .cpp file.
class RunHistory final {
public:
    explicit RunHistory(Database& db) : m_db(db) {}

    std::vector<RunLine> list(const RunFilter& filter = {}, Page page = {}) const;  ///< newest first
    std::int64_t count(const RunFilter& filter = {}) const;
    std::optional<RunLine> find(RunId run) const;

    /// What counts: graded runs of type assess, no others. Newest first.
    std::vector<RunLine> gradesOf(PersonId person) const;
    /// All the others of this person; what was sailed as a demo is nobody's.
    std::vector<RunLine> practiceOf(PersonId person) const;

private:
    Database& m_db;  ///< outlives every repository
};

}  // namespace sagara::db
