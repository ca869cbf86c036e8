#include "db/RunHistory.h"

#include "db/Database.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;

const auto kSelect =
    u"SELECT run_id, person_id, person_name, class_name, scenario_key, scenario_name, type, level, "
    "started_utc, status, sim_time_us, recording_file, score, passed, overruled_score, overruled_passed, "
    "signed_name, signed_utc FROM run_history "_s;
const auto kNewestFirst = u"ORDER BY started_utc DESC, run_id DESC "_s;
/// Each condition holds when nothing is asked: four pairs of values.
const auto kFilter =
    u"WHERE (? IS NULL OR person_id = ?) AND (? IS NULL OR class_id = ?) "
    "AND (? IS NULL OR scenario_key = ?) AND (? IS NULL OR type = ?) "_s;

std::optional<ScoreAndPass> readScore(const Query& row, const QString& score, const QString& passed) {
    if (row.isNull(score)) return std::nullopt;
    return ScoreAndPass{row.real(score), row.flag(passed)};
}

RunLine readLine(const Query& row) {
    RunLine line;
    line.run = row.id<RunId>(u"run_id"_s);
    if (!row.isNull(u"person_id"_s)) line.person = row.id<PersonId>(u"person_id"_s);
    line.personName = row.text(u"person_name"_s);
    line.className = row.text(u"class_name"_s);
    line.scenarioKey = row.text(u"scenario_key"_s);
    line.scenarioName = row.text(u"scenario_name"_s);
    line.type = row.word(u"type"_s, parseRunType);
    line.level = static_cast<int>(row.integer(u"level"_s));
    line.started = row.utc(u"started_utc"_s);
    line.status = row.word(u"status"_s, parseRunStatus);
    line.simTime = {row.integer(u"sim_time_us"_s)};
    line.recordingFile = row.text(u"recording_file"_s);
    line.automatic = readScore(row, u"score"_s, u"passed"_s);
    line.overruled = readScore(row, u"overruled_score"_s, u"overruled_passed"_s);
    line.signedBy = row.text(u"signed_name"_s);
    if (!row.isNull(u"signed_utc"_s)) line.signedAt = row.utc(u"signed_utc"_s);
    return line;
}

std::vector<RunLine> readAll(Query row) {
    std::vector<RunLine> lines;
    while (row.next()) lines.push_back(readLine(row));
    return lines;
}

template <typename... More>
Query filtered(Connection& connection, const QString& sql, const RunFilter& f, const More&... more) {
    const auto scenario = f.scenarioKey.empty() ? std::nullopt : std::optional(f.scenarioKey);
    const auto type = f.type ? std::optional(toText(*f.type)) : std::nullopt;
    return Query(connection, sql, f.person, f.person, f.schoolClass, f.schoolClass, scenario, scenario, type,
                 type, more...);
}

}  // namespace

std::vector<RunLine> RunHistory::list(const RunFilter& filter, Page page) const {
    return readAll(filtered(m_db.connection(), kSelect + kFilter + kNewestFirst + u"LIMIT ? OFFSET ?"_s,
                            filter, page.limit, page.offset));
}

std::int64_t RunHistory::count(const RunFilter& filter) const {
    Query row = filtered(m_db.connection(), u"SELECT count(*) AS runs FROM run_history "_s + kFilter, filter);
    row.next();
    return row.integer(u"runs"_s);
}

std::optional<RunLine> RunHistory::find(RunId run) const {
    Query row(m_db.connection(), kSelect + u"WHERE run_id = ?"_s, run);
    if (!row.next()) return std::nullopt;
    return readLine(row);
}

std::vector<RunLine> RunHistory::gradesOf(PersonId person) const {
    return readAll(
        Query(m_db.connection(),
              kSelect + u"WHERE person_id = ? AND type = 'assess' AND score IS NOT NULL "_s + kNewestFirst,
              person));
}

std::vector<RunLine> RunHistory::practiceOf(PersonId person) const {
    return readAll(
        Query(m_db.connection(),
              kSelect + u"WHERE person_id = ? AND type NOT IN ('assess', 'demo') "_s + kNewestFirst, person));
}

}  // namespace sagara::db
