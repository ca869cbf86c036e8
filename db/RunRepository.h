#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/SimTime.h"
#include "core/base/Utc.h"
#include "db/PersonRepository.h"

namespace sagara::db {

enum class RunId : std::int64_t {};
enum class RunType { Familiarise, Train, Assess, SelfStudy, Demo };
enum class RunStatus { Running, Finished, Aborted };
std::string_view toText(RunType type);
std::string_view toText(RunStatus status);
std::optional<RunType> parseRunType(std::string_view text);
std::optional<RunStatus> parseRunStatus(std::string_view text);

struct NewRun {
    std::optional<PersonId> person;
    std::string scenarioKey;
    std::string scenarioName;  ///< as it was called then
    RunType type = RunType::Train;
    int level = 1;  ///< 1 to 5
    std::uint64_t seed = 0;
    std::string buildId;
    core::Utc started;
    std::string recordingFile;  ///< DataFolder::nameOf; no two runs share one
};

struct RunResult {
    RunStatus status = RunStatus::Finished;  ///< Finished or Aborted
    core::Utc finished;
    core::SimTime simTime;
    std::optional<std::uint64_t> stateHash;
};

struct RunRecord {
    RunId id{};
    NewRun start;
    RunStatus status = RunStatus::Running;
    std::optional<core::Utc> finished;  ///< none while running
    core::SimTime simTime;
    std::optional<std::uint64_t> stateHash;
};

struct Page {
    int limit = 100;
    int offset = 0;
};

/// Exercises sailed here. All SQL about table `run` is in this class's .cpp file. The recording itself is a
/// file.
class RunRepository final {
public:
    explicit RunRepository(Database& db) : m_db(db) {}

    RunId start(const NewRun& run);
    /// False, and nothing changed, when that run is not there or has ended already.
    bool finish(RunId id, const RunResult& result);
    /// The file of that name holds another run from now on. A run it held before stays, and says so in place
    /// of the name.
    void releaseRecording(std::string_view recordingFile);
    std::optional<RunRecord> find(RunId id) const;
    std::optional<RunRecord> findByRecording(std::string_view recordingFile) const;
    std::vector<RunRecord> list(Page page = {}) const;  ///< newest first
    /// Sailed to the end by somebody named, begun then or later.
    std::vector<RunRecord> finished(core::Utc since) const;
    std::vector<RunRecord> finishedBy(PersonId person) const;
    std::int64_t count() const;

private:
    Database& m_db;  ///< outlives every repository
};

}  // namespace sagara::db
