#include "db/RunRepository.h"

#include <cassert>

#include "core/base/Hash.h"
#include "db/Database.h"
#include "db/sql/Query.h"
#include "db/sql/Words.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;

constexpr Word<RunType> kTypes[] = {{RunType::Familiarise, "familiarise"},
                                    {RunType::Train, "train"},
                                    {RunType::Assess, "assess"},
                                    {RunType::SelfStudy, "self-study"},
                                    {RunType::Demo, "demo"}};
constexpr Word<RunStatus> kStatuses[] = {
    {RunStatus::Running, "running"}, {RunStatus::Finished, "finished"}, {RunStatus::Aborted, "aborted"}};

const auto kSelect =
    u"SELECT id, person_id, scenario_key, scenario_name, type, level, seed, build_id, started_utc, "
    "finished_utc, status, sim_time_us, state_hash, recording_file FROM run "_s;

std::optional<PersonId> readPersonId(const Query& row) {
    if (row.isNull(u"person_id"_s)) return std::nullopt;
    return row.id<PersonId>(u"person_id"_s);
}

std::optional<core::Utc> readFinished(const Query& row) {
    if (row.isNull(u"finished_utc"_s)) return std::nullopt;
    return row.utc(u"finished_utc"_s);
}

std::optional<std::uint64_t> readStateHash(const Query& row) {
    if (row.isNull(u"state_hash"_s)) return std::nullopt;
    return row.hash(u"state_hash"_s);
}

NewRun readStart(const Query& row) {
    return {.person = readPersonId(row),
            .scenarioKey = row.text(u"scenario_key"_s),
            .scenarioName = row.text(u"scenario_name"_s),
            .type = row.word(u"type"_s, parseRunType),
            .level = static_cast<int>(row.integer(u"level"_s)),
            .seed = unsignedBits(row.integer(u"seed"_s)),
            .buildId = row.text(u"build_id"_s),
            .started = row.utc(u"started_utc"_s),
            .recordingFile = row.text(u"recording_file"_s)};
}

RunRecord readRun(const Query& row) {
    return {.id = row.id<RunId>(u"id"_s),
            .start = readStart(row),
            .status = row.word(u"status"_s, parseRunStatus),
            .finished = readFinished(row),
            .simTime = {row.integer(u"sim_time_us"_s)},
            .stateHash = readStateHash(row)};
}

std::optional<RunRecord> readOne(Query row) {
    if (!row.next()) return std::nullopt;
    return readRun(row);
}

std::vector<RunRecord> readAll(Query row) {
    std::vector<RunRecord> runs;
    while (row.next()) runs.push_back(readRun(row));
    return runs;
}

std::optional<std::string> hashText(std::optional<std::uint64_t> hash) {
    if (!hash) return std::nullopt;
    return core::toHex(*hash);
}

}  // namespace

std::string_view toText(RunType type) { return wordOf(kTypes, type); }
std::string_view toText(RunStatus status) { return wordOf(kStatuses, status); }
std::optional<RunType> parseRunType(std::string_view text) { return valueOf(kTypes, text); }
std::optional<RunStatus> parseRunStatus(std::string_view text) { return valueOf(kStatuses, text); }

RunId RunRepository::start(const NewRun& run) {
    const Query insert(
        m_db.connection(),
        u"INSERT INTO run (person_id, scenario_key, scenario_name, type, level, seed, build_id, "
        "started_utc, status, recording_file) VALUES (?, ?, ?, ?, ?, ?, ?, ?, 'running', ?)"_s,
        run.person, run.scenarioKey, run.scenarioName, toText(run.type), run.level, signedBits(run.seed),
        run.buildId, run.started, run.recordingFile);
    return RunId{insert.newId()};
}

bool RunRepository::finish(RunId id, const RunResult& result) {
    assert(result.status != RunStatus::Running);
    return execute(m_db.connection(),
                   u"UPDATE run SET status = ?, finished_utc = ?, sim_time_us = ?, state_hash = ? "
                   "WHERE id = ? AND status = 'running'"_s,
                   toText(result.status), result.finished, result.simTime.us, hashText(result.stateHash),
                   id) == 1;
}

void RunRepository::releaseRecording(std::string_view recordingFile) {
    execute(m_db.connection(),
            u"UPDATE run SET recording_file = recording_file || ' (replaced, run ' || id || ')' "
            "WHERE recording_file = ?"_s,
            recordingFile);
}

std::optional<RunRecord> RunRepository::find(RunId id) const {
    return readOne(Query(m_db.connection(), kSelect + u"WHERE id = ?"_s, id));
}

std::optional<RunRecord> RunRepository::findByRecording(std::string_view recordingFile) const {
    return readOne(Query(m_db.connection(), kSelect + u"WHERE recording_file = ?"_s, recordingFile));
}

std::vector<RunRecord> RunRepository::list(Page page) const {
    return readAll(Query(m_db.connection(),
                         kSelect + u"ORDER BY started_utc DESC, id DESC LIMIT ? OFFSET ?"_s, page.limit,
                         page.offset));
}

std::vector<RunRecord> RunRepository::finished(core::Utc since) const {
    return readAll(Query(m_db.connection(),
                         kSelect + u"WHERE started_utc >= ? AND status = 'finished' "
                                   "AND person_id IS NOT NULL ORDER BY id"_s,
                         since));
}

std::vector<RunRecord> RunRepository::finishedBy(PersonId person) const {
    return readAll(Query(m_db.connection(),
                         kSelect + u"WHERE status = 'finished' AND person_id = ? ORDER BY id"_s, person));
}

std::int64_t RunRepository::count() const {
    Query row(m_db.connection(), u"SELECT count(*) AS runs FROM run"_s);
    row.next();
    return row.integer(u"runs"_s);
}

}  // namespace sagara::db
