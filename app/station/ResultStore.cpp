#include "app/station/ResultStore.h"

#include <QCoreApplication>
#include <nlohmann/json.hpp>

#include "app/run/RecordingReport.h"
#include "db/AssessmentRepository.h"
#include "db/GradeRepository.h"

namespace sagara::station {
namespace {

using nlohmann::json;
using roster::Result;
using roster::Trouble;

QString text(const char* source) { return QCoreApplication::translate("roster", source); }

double numberIn(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_number() ? found->get<double>() : 0.0;
}

QString wordsIn(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? fromStd(found->get<std::string>()) : QString();
}

bool flagIn(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_boolean() && found->get<bool>();
}

/// Arrays of the grade table, as RunSummary.h writes them; older rows name tasks by their id only.
void readGrade(const db::Grade& grade, Result& result) {
    result.automatic = roster::Score{grade.score, grade.passed};
    for (const json& t : json::parse(grade.tasks, nullptr, false)) {
        if (!t.is_object()) continue;
        const QString title = wordsIn(t, "title");
        result.tasks.push_back(
            {title.isEmpty() ? wordsIn(t, "id") : title, flagIn(t, "done"), numberIn(t, "time_s")});
    }
    for (const json& l : json::parse(grade.deductions, nullptr, false)) {
        if (!l.is_object()) continue;
        result.losses.push_back({numberIn(l, "time_s"), wordsIn(l, "title"), wordsIn(l, "unit"),
                                 numberIn(l, "value"), numberIn(l, "limit"), numberIn(l, "points"),
                                 flagIn(l, "fails")});
    }
}

void readSummary(const run::RunSummary& summary, Result& result) {
    result.automatic = roster::Score{summary.score, summary.passed};
    result.whyNot = fromStd(summary.whyNot);
    result.duration_s = summary.simTime_s;
    result.tasks.clear();
    result.losses.clear();
    for (const auto& t : summary.tasks) result.tasks.push_back({fromStd(t.title), t.done, t.time_s});
    for (const auto& l : summary.losses)
        result.losses.push_back(
            {l.time_s, fromStd(l.title), fromStd(l.unit), l.value, l.limit, l.points, l.fails});
}

/// What the database does not keep in words.
QString whyNotOf(const Result& result) {
    if (!result.automatic || result.automatic->passed) return {};
    for (const auto& loss : result.losses)
        if (loss.fails) return text("failed: %1").arg(loss.title);
    for (const auto& task : result.tasks)
        if (!task.done) return text("not done: %1").arg(task.title);
    return text("the score is below the pass mark");
}

db::Assessment assessmentOf(const roster::Entry& entry) {
    db::Assessment a;
    a.comment = entry.comment.toStdString();
    if (entry.overrule) a.overrule = db::Overrule{entry.score, entry.passed, entry.reason.toStdString()};
    return a;
}

}  // namespace

ResultStore::ResultStore(Frame& frame, std::filesystem::path recording, run::RunSummary summary)
    : m_frame(frame), m_recording(std::move(recording)), m_summary(std::move(summary)) {
    attempt(frame.store(), [this](db::Database& database) -> Trouble {
        const auto record =
            db::RunRepository(database).findByRecording(m_frame.store().folder().nameOf(m_recording));
        if (record && record->status != db::RunStatus::Running) m_run = record->id;
        return std::nullopt;
    });
}

Result ResultStore::result() {
    Result result;
    result.cannotAssess = text(
        "This run is not in the database yet, so no assessment can be kept. Its recording is "
        "safe and is filed at a later start; assess it from the run history then.");
    const Trouble trouble = attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        if (m_run) readFiled(database, result);
        return std::nullopt;
    });
    if (m_summary) {
        readSummary(*m_summary, result);
        if (result.mission.isEmpty()) result.mission = fromStd(m_summary->scenario);
    }
    if (trouble) result.cannotAssess += QLatin1Char('\n') + *trouble;
    return result;
}

void ResultStore::readFiled(db::Database& database, Result& result) const {
    const auto line = db::RunHistory(database).find(*m_run);
    if (!line) return;
    result.cannotAssess =
        line->status == db::RunStatus::Running
            ? text("This run is under way or was cut off; it can be assessed when it has ended.")
            : QString();
    result.mission = fromStd(line->scenarioName);
    result.person = fromStd(line->personName);
    result.type = fromStd(db::toText(line->type));
    result.level = line->level;
    result.started = line->started;
    result.duration_s = line->simTime.seconds();
    if (const auto grade = db::GradeRepository(database).find(*m_run)) readGrade(*grade, result);
    result.whyNot = whyNotOf(result);
    const auto record = db::AssessmentRepository(database).find(*m_run);
    if (!record) return;
    result.entry.comment = fromStd(record->assessment.comment);
    if (const auto& overrule = record->assessment.overrule) {
        result.entry.overrule = true;
        result.entry.score = overrule->score;
        result.entry.passed = overrule->passed;
        result.entry.reason = fromStd(overrule->reason);
    }
    if (!record->signedOff) return;
    result.signedBy = fromStd(record->signedOff->name);
    result.signedAt = record->signedOff->at;
}

std::vector<roster::Person> ResultStore::assessors() {
    std::vector<roster::Person> assessors;
    attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        for (const db::PersonRecord& p : db::PersonRepository(database).inUse())
            if (p.role != db::Role::Trainee) assessors.push_back(personOf(p, {}));
        return std::nullopt;
    });
    return assessors;
}

Trouble ResultStore::save(const roster::Entry& entry) {
    return attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        if (!m_run) return text("The run is not in the database yet.");
        const auto kept = db::AssessmentRepository(database).put(*m_run, assessmentOf(entry), run::now());
        if (!kept) return fromStd(db::toText(kept.error()));
        return std::nullopt;
    });
}

Trouble ResultStore::signOff(const roster::Entry& entry, std::int64_t by) {
    if (const Trouble trouble = save(entry)) return trouble;
    return attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        const auto signedOff = db::AssessmentRepository(database).sign(*m_run, db::PersonId{by}, run::now());
        if (!signedOff) return fromStd(db::toText(signedOff.error()));
        return std::nullopt;
    });
}

Trouble ResultStore::openDebrief() {
    if (!m_recording.empty()) return debriefOf(m_frame, m_frame.store().folder().nameOf(m_recording));
    std::string recording;
    const Trouble trouble = attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        const auto record = db::RunRepository(database).find(*m_run);
        if (!record) return text("The run is no longer in the database.");
        recording = record->start.recordingFile;
        return std::nullopt;
    });
    return trouble ? trouble : debriefOf(m_frame, recording);
}

core::Result<roster::Job, QString> ResultStore::reportJob(const QString& file) {
    if (m_run) return reportJobOf(m_frame.store(), *m_run, file);
    return roster::Job([recording = m_recording, hulls = m_frame.store().hulls(),
                        to = std::filesystem::path(file.toStdString())](roster::JobControl& control) {
        return fromStd(run::writeRecordingReport(recording, std::nullopt, to, hulls, [&control](int percent) {
            control.setPercent(percent);
            return !control.cancelled();
        }));
    });
}

}  // namespace sagara::station
