#include "db/GradeRepository.h"

#include "db/Database.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;

Grade readGrade(const Query& row) {
    return {.score = row.real(u"score"_s),
            .passed = row.flag(u"passed"_s),
            .tasks = row.text(u"tasks"_s),
            .deductions = row.text(u"deductions"_s),
            .advisory = row.flag(u"advisory"_s),
            .made = row.utc(u"made_utc"_s)};
}

}  // namespace

void GradeRepository::put(RunId run, const Grade& grade) {
    execute(m_db.connection(),
            u"INSERT INTO grade (run_id, score, passed, tasks, deductions, advisory, made_utc) "
            "VALUES (?, ?, ?, ?, ?, ?, ?) "
            "ON CONFLICT (run_id) DO UPDATE SET score = excluded.score, passed = excluded.passed, "
            "tasks = excluded.tasks, deductions = excluded.deductions, advisory = excluded.advisory, "
            "made_utc = excluded.made_utc"_s,
            run, grade.score, grade.passed, grade.tasks, grade.deductions, grade.advisory, grade.made);
}

std::optional<Grade> GradeRepository::find(RunId run) const {
    Query row(m_db.connection(),
              u"SELECT score, passed, tasks, deductions, advisory, made_utc FROM grade WHERE run_id = ?"_s,
              run);
    if (!row.next()) return std::nullopt;
    return readGrade(row);
}

}  // namespace sagara::db
