#include "db/AssessmentRepository.h"

#include <QList>
#include <QString>

#include "db/Database.h"
#include "db/Transaction.h"
#include "db/sql/Query.h"
#include "db/sql/Words.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;
using core::Result;

constexpr int kLongestComment_characters = 4000;
constexpr int kLongestReason_characters = 1000;
constexpr Word<AssessError> kErrors[] = {
    {AssessError::SignedAlready, "this run was signed off; its assessment can no longer be changed"},
    {AssessError::ReasonEmpty, "the reason is empty, expected why the automatic result is overruled"},
    {AssessError::ScoreOutOfRange, "the score is out of range, expected 0 to 100"},
    {AssessError::CommentTooLong,
     "the text is too long, expected up to 4000 characters of comment and 1000 of reason"},
    {AssessError::RunNotEnded, "this run has not ended, expected one that has"},
    {AssessError::NotATrainer, "this person may not sign off, expected a trainer or an admin in use"},
    {AssessError::OwnRun, "nobody signs off a run of their own, expected another trainer"}};

std::optional<Overrule> readOverrule(const Query& row) {
    if (row.isNull(u"overruled_score"_s)) return std::nullopt;
    return Overrule{row.real(u"overruled_score"_s), row.flag(u"overruled_passed"_s), row.text(u"reason"_s)};
}

std::optional<SignOff> readSignOff(const Query& row) {
    if (row.isNull(u"signed_utc"_s)) return std::nullopt;
    return SignOff{row.id<PersonId>(u"signed_by"_s), row.text(u"signed_name"_s), row.utc(u"signed_utc"_s)};
}

qsizetype characters(const std::string& text) { return QString::fromStdString(text).toUcs4().size(); }
bool isBlank(const std::string& text) { return QString::fromStdString(text).trimmed().isEmpty(); }

std::optional<AssessError> faultOf(const Assessment& a) {
    if (characters(a.comment) > kLongestComment_characters) return AssessError::CommentTooLong;
    if (!a.overrule) return std::nullopt;
    if (!(a.overrule->score >= 0.0 && a.overrule->score <= 100.0)) return AssessError::ScoreOutOfRange;
    if (isBlank(a.overrule->reason)) return AssessError::ReasonEmpty;
    if (characters(a.overrule->reason) > kLongestReason_characters) return AssessError::CommentTooLong;
    return std::nullopt;
}

}  // namespace

std::string_view toText(AssessError error) { return wordOf(kErrors, error); }

std::optional<AssessmentRecord> AssessmentRepository::find(RunId run) const {
    Query row(m_db.connection(),
              u"SELECT comment, overruled_score, overruled_passed, reason, changed_utc, signed_by, "
              "signed_name, signed_utc FROM assessment WHERE run_id = ?"_s,
              run);
    if (!row.next()) return std::nullopt;
    return AssessmentRecord{
        {row.text(u"comment"_s), readOverrule(row)}, row.utc(u"changed_utc"_s), readSignOff(row)};
}

Result<RunId, AssessError> AssessmentRepository::put(RunId run, const Assessment& a, core::Utc now) {
    if (const auto fault = faultOf(a)) return *fault;
    Transaction transaction(m_db);
    const auto known = find(run);
    if (known && known->signedOff) return AssessError::SignedAlready;
    const auto score = a.overrule ? std::optional(a.overrule->score) : std::nullopt;
    const auto passed = a.overrule ? std::optional(a.overrule->passed) : std::nullopt;
    execute(m_db.connection(),
            u"INSERT INTO assessment (run_id, comment, overruled_score, overruled_passed, reason, "
            "changed_utc) VALUES (?, ?, ?, ?, ?, ?) ON CONFLICT (run_id) DO UPDATE SET "
            "comment = excluded.comment, overruled_score = excluded.overruled_score, "
            "overruled_passed = excluded.overruled_passed, reason = excluded.reason, "
            "changed_utc = excluded.changed_utc"_s,
            run, a.comment, score, passed, a.overrule ? a.overrule->reason : std::string(), now);
    transaction.commit();
    return run;
}

Result<SignOff, AssessError> AssessmentRepository::sign(RunId run, PersonId by, core::Utc now) {
    Transaction transaction(m_db);
    const auto known = find(run);
    if (known && known->signedOff) return AssessError::SignedAlready;
    const auto record = RunRepository(m_db).find(run);
    if (!record || record->status == RunStatus::Running) return AssessError::RunNotEnded;
    const auto person = PersonRepository(m_db).find(by);
    if (!person || person->retired || person->role == Role::Trainee) return AssessError::NotATrainer;
    if (record->start.person == by) return AssessError::OwnRun;
    if (!known) {
        if (const auto put_ = put(run, {}, now); !put_) return put_.error();
    }
    execute(m_db.connection(),
            u"UPDATE assessment SET signed_by = ?, signed_name = ?, signed_utc = ? WHERE run_id = ?"_s, by,
            person->name, now, run);
    transaction.commit();
    return SignOff{by, person->name, now};
}

}  // namespace sagara::db
