#include "app/station/RosterStore.h"

#include <QCoreApplication>

#include "app/run/RecordingReport.h"
#include "app/station/RosterDoor.h"
#include "db/AssessmentRepository.h"
#include "db/DocumentRepository.h"
#include "db/Transaction.h"

namespace sagara::station {
namespace {

using roster::Trouble;

QString text(const char* source) { return QCoreApplication::translate("roster", source); }

template <typename IdOfTable>
std::optional<IdOfTable> idOf(std::int64_t id) {
    if (id == 0) return std::nullopt;
    return IdOfTable{id};
}

db::Role roleOf(roster::Role role) {
    switch (role) {
        case roster::Role::Trainer:
            return db::Role::Trainer;
        case roster::Role::Admin:
            return db::Role::Admin;
        case roster::Role::Trainee:
            break;
    }
    return db::Role::Trainee;
}

roster::Role roleOf(db::Role role) {
    switch (role) {
        case db::Role::Trainer:
            return roster::Role::Trainer;
        case db::Role::Admin:
            return roster::Role::Admin;
        case db::Role::Trainee:
            break;
    }
    return roster::Role::Trainee;
}

/// The class of that name, made when there is none; no class for an empty name.
core::Result<std::optional<db::ClassId>, QString> classNamed(db::Database& database, const QString& name,
                                                             core::Utc now) {
    using Named = core::Result<std::optional<db::ClassId>, QString>;
    if (name.isEmpty()) return Named(std::optional<db::ClassId>());
    db::ClassRepository classes(database);
    if (const auto known = classes.findByName(name.toStdString())) return Named(std::optional(known->id));
    const auto added = classes.add(name.toStdString(), now);
    if (!added) return fromStd(db::toText(added.error()));
    return Named(std::optional(added.value()));
}

/// Gives the id, or why this person cannot be kept.
core::Result<std::int64_t, QString> keep(db::Database& database, const roster::Person& p, core::Utc now) {
    const auto schoolClass = classNamed(database, p.className, now);
    if (!schoolClass) return schoolClass.error();
    const db::NewPerson person{p.name.toStdString(), roleOf(p.role),       p.number.toStdString(),
                               p.rank.toStdString(), p.note.toStdString(), *schoolClass};
    db::PersonRepository people(database);
    const auto kept = p.id == 0 ? people.add(person, now) : people.change(db::PersonId{p.id}, person);
    if (!kept) return fromStd(db::toText(kept.error()));
    return static_cast<std::int64_t>(kept.value());
}

std::map<db::ClassId, std::string> classNames(db::Database& database,
                                              const std::vector<db::PersonRecord>& people) {
    std::map<db::ClassId, std::string> names;
    const db::ClassRepository classes(database);
    for (const db::PersonRecord& p : people) {
        if (!p.schoolClass || names.contains(*p.schoolClass)) continue;
        if (const auto known = classes.find(*p.schoolClass)) names[known->id] = known->name;
    }
    return names;
}

roster::State stateOf(db::AssignmentState state) {
    switch (state) {
        case db::AssignmentState::Done:
            return roster::State::Done;
        case db::AssignmentState::Late:
            return roster::State::Late;
        case db::AssignmentState::Open:
            break;
    }
    return roster::State::Open;
}

roster::Assignment assignmentOf(db::Database& database, const db::AssignmentProgress& progress) {
    const db::NewAssignment& what = progress.assignment.what;
    roster::Assignment a;
    a.id = static_cast<std::int64_t>(progress.assignment.id);
    a.mission = fromStd(what.scenarioName);
    if (const auto* const person = std::get_if<db::PersonId>(&what.forWhom)) {
        a.personId = static_cast<std::int64_t>(*person);
        if (const auto known = db::PersonRepository(database).find(*person)) a.forWhom = fromStd(known->name);
    } else {
        const db::ClassId schoolClass = std::get<db::ClassId>(what.forWhom);
        a.classId = static_cast<std::int64_t>(schoolClass);
        if (const auto known = db::ClassRepository(database).find(schoolClass))
            a.forWhom = text("Class %1").arg(fromStd(known->name));
    }
    a.due = what.due;
    a.created = progress.assignment.created;
    a.type = fromStd(db::toText(what.type));
    a.level = what.level;
    if (what.assignedBy)
        if (const auto by = db::PersonRepository(database).find(*what.assignedBy))
            a.assignedBy = fromStd(by->name);
    a.state = progress.assignment.withdrawn ? roster::State::Withdrawn : stateOf(progress.state);
    for (const db::MemberProgress& m : progress.members)
        a.members.push_back({fromStd(m.person.name), stateOf(m.state), m.done});
    return a;
}

std::optional<roster::Score> scoreOf(const std::optional<db::ScoreAndPass>& score) {
    if (!score) return std::nullopt;
    return roster::Score{score->score, score->passed};
}

roster::Run runOf(const db::RunLine& line) {
    roster::Run r;
    r.id = static_cast<std::int64_t>(line.run);
    r.started = line.started;
    r.person = fromStd(line.personName);
    r.className = fromStd(line.className);
    r.mission = fromStd(line.scenarioName);
    r.type = fromStd(db::toText(line.type));
    r.level = line.level;
    r.status = fromStd(db::toText(line.status));
    r.duration_s = line.simTime.seconds();
    r.automatic = scoreOf(line.automatic);
    r.overruled = scoreOf(line.overruled);
    r.signedBy = fromStd(line.signedBy);
    return r;
}

db::RunFilter filterOf(const roster::RunFilter& f) {
    db::RunFilter filter;
    filter.person = idOf<db::PersonId>(f.personId);
    filter.schoolClass = idOf<db::ClassId>(f.classId);
    filter.scenarioKey = f.missionKey.toStdString();
    if (!f.type.isEmpty()) filter.type = db::parseRunType(f.type.toStdString());
    return filter;
}

std::optional<report::AssessorNote> noteOf(const std::optional<db::AssessmentRecord>& record) {
    if (!record) return std::nullopt;
    report::AssessorNote note;
    note.comment = record->assessment.comment;
    if (const auto& overrule = record->assessment.overrule)
        note.overrule = {overrule->score, overrule->passed, overrule->reason};
    if (record->signedOff) {
        note.signedBy = record->signedOff->name;
        note.signedAt = record->signedOff->at;
    }
    return note;
}

}  // namespace

roster::Person personOf(const db::PersonRecord& record, const std::string& className) {
    roster::Person p;
    p.id = static_cast<std::int64_t>(record.id);
    p.name = fromStd(record.name);
    p.number = fromStd(record.number);
    p.rank = fromStd(record.rank);
    p.note = fromStd(record.note);
    p.role = roleOf(record.role);
    if (record.schoolClass) p.classId = static_cast<std::int64_t>(*record.schoolClass);
    p.className = fromStd(className);
    p.retired = record.retired;
    return p;
}

core::Result<roster::Job, QString> reportJobOf(run::Store& store, db::RunId run, const QString& file) {
    std::filesystem::path recording;
    std::optional<report::AssessorNote> note;
    const Trouble trouble = attempt(store, [&](db::Database& database) -> Trouble {
        const auto record = db::RunRepository(database).find(run);
        if (!record) return text("The run is no longer in the database.");
        recording = store.folder().pathOf(record->start.recordingFile);
        note = noteOf(db::AssessmentRepository(database).find(run));
        return std::nullopt;
    });
    if (trouble) return *trouble;
    const std::filesystem::path to = file.toStdString();
    return roster::Job([recording, note, to, hulls = store.hulls()](roster::JobControl& control) {
        return fromStd(run::writeRecordingReport(recording, note, to, hulls, [&control](int percent) {
            control.setPercent(percent);
            return !control.cancelled();
        }));
    });
}

Trouble debriefOf(Frame& frame, const std::string& recordingName) {
    const std::filesystem::path recording = frame.store().folder().pathOf(recordingName);
    std::error_code none;
    if (!std::filesystem::exists(recording, none))
        return text("The recording %1 is not there any more; without it nothing can be played.")
            .arg(fromStd(recording.string()));
    if (const auto trouble = frame.openDebrief(recording)) return fromStd(*trouble);
    return std::nullopt;
}

template <typename Read>
void RosterStore::read(Read&& act) {
    m_trouble = attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
                    act(database);
                    return std::nullopt;
                }).value_or(QString());
}

core::Utc RosterStore::now() const { return run::now(); }

std::vector<roster::Person> RosterStore::people() {
    std::vector<roster::Person> people;
    read([&](db::Database& database) {
        const auto records = db::PersonRepository(database).all();
        const auto names = classNames(database, records);
        for (const db::PersonRecord& p : records)
            people.push_back(personOf(p, p.schoolClass ? names.at(*p.schoolClass) : std::string()));
    });
    return people;
}

std::vector<roster::SchoolClass> RosterStore::classes() {
    std::vector<roster::SchoolClass> classes;
    read([&](db::Database& database) {
        std::map<db::ClassId, int> people;
        for (const db::PersonRecord& p : db::PersonRepository(database).inUse())
            if (p.schoolClass) ++people[*p.schoolClass];
        for (const db::ClassRecord& c : db::ClassRepository(database).inUse())
            classes.push_back({static_cast<std::int64_t>(c.id), fromStd(c.name), people[c.id]});
    });
    return classes;
}

std::vector<roster::Mission> RosterStore::missions() {
    std::vector<roster::Mission> missions;
    read([&](db::Database& database) {
        for (const auto& e : db::DocumentRepository(database, db::DocumentTable::Scenario).inUse())
            missions.push_back({fromStd(e.key), fromStd(e.name)});
    });
    return missions;
}

core::Result<std::int64_t, QString> RosterStore::savePerson(const roster::Person& person) {
    std::int64_t id = 0;
    const Trouble trouble = attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        db::Transaction transaction(database);
        const auto kept = keep(database, person, now());
        if (!kept) return kept.error();
        id = *kept;
        transaction.commit();
        return std::nullopt;
    });
    if (trouble) return *trouble;
    return id;
}

Trouble RosterStore::retirePerson(std::int64_t id, bool retired) {
    return attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        db::PersonRepository people(database);
        if (retired) return people.retire(db::PersonId{id}), std::nullopt;
        const auto restored = people.restore(db::PersonId{id});
        if (!restored) return fromStd(db::toText(restored.error()));
        return std::nullopt;
    });
}

Trouble RosterStore::movePeople(const std::vector<std::int64_t>& ids, const QString& className) {
    return attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        db::Transaction transaction(database);
        const auto schoolClass = classNamed(database, className, now());
        if (!schoolClass) return schoolClass.error();
        db::PersonRepository people(database);
        for (const std::int64_t id : ids) people.move(db::PersonId{id}, *schoolClass);
        transaction.commit();
        return std::nullopt;
    });
}

Trouble RosterStore::importPeople(const std::vector<roster::Person>& people) {
    return attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        db::Transaction transaction(database);
        for (const roster::Person& p : people) {
            const auto kept = keep(database, p, now());
            if (!kept) return text("%1: %2").arg(p.name, kept.error());
        }
        transaction.commit();
        return std::nullopt;
    });
}

Trouble RosterStore::addClass(const QString& name) {
    return attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        const auto added = db::ClassRepository(database).add(name.toStdString(), now());
        if (!added) return fromStd(db::toText(added.error()));
        return std::nullopt;
    });
}

Trouble RosterStore::renameClass(std::int64_t id, const QString& name) {
    return attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        const auto renamed = db::ClassRepository(database).rename(db::ClassId{id}, name.toStdString());
        if (!renamed) return fromStd(db::toText(renamed.error()));
        return std::nullopt;
    });
}

Trouble RosterStore::retireClass(std::int64_t id) {
    return attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        db::ClassRepository(database).retire(db::ClassId{id});
        return std::nullopt;
    });
}

std::vector<roster::Assignment> RosterStore::assignments() {
    std::vector<roster::Assignment> assignments;
    read([&](db::Database& database) {
        for (const db::AssignmentProgress& p : db::assignmentProgress(database, now()))
            assignments.push_back(assignmentOf(database, p));
    });
    return assignments;
}

Trouble RosterStore::assign(const roster::NewAssignment& a) {
    return attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        db::NewAssignment wanted;
        wanted.scenarioKey = a.mission.key.toStdString();
        wanted.scenarioName = a.mission.name.toStdString();
        if (a.classId != 0) wanted.forWhom = db::ClassId{a.classId};
        if (a.personId != 0) wanted.forWhom = db::PersonId{a.personId};
        wanted.due = a.due;
        wanted.type = db::parseRunType(a.type.toStdString()).value_or(db::RunType::Demo);
        wanted.level = a.level;
        wanted.assignedBy = idOf<db::PersonId>(a.assignedBy);
        const auto added = db::AssignmentRepository(database).add(wanted, now());
        if (!added) return fromStd(db::toText(added.error()));
        return std::nullopt;
    });
}

Trouble RosterStore::withdraw(std::int64_t id) {
    return attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        db::AssignmentRepository(database).withdraw(db::AssignmentId{id}, now());
        return std::nullopt;
    });
}

std::vector<roster::Run> RosterStore::runs(const roster::RunFilter& filter, int most) {
    std::vector<roster::Run> runs;
    read([&](db::Database& database) {
        for (const db::RunLine& line : db::RunHistory(database).list(filterOf(filter), {most, 0}))
            runs.push_back(runOf(line));
    });
    return runs;
}

int RosterStore::runCount(const roster::RunFilter& filter) {
    int count = 0;
    read([&](db::Database& database) {
        count = static_cast<int>(db::RunHistory(database).count(filterOf(filter)));
    });
    return count;
}

roster::Record RosterStore::recordOf(std::int64_t person) {
    roster::Record record;
    read([&](db::Database& database) {
        const db::RunHistory history(database);
        for (const db::RunLine& line : history.gradesOf(db::PersonId{person})) {
            ++record.grades;
            if (line.valid() && line.valid()->passed) ++record.passedGrades;
        }
        record.practice = static_cast<int>(history.practiceOf(db::PersonId{person}).size());
    });
    return record;
}

Trouble RosterStore::openDebrief(std::int64_t run) {
    std::string recording;
    const Trouble trouble = attempt(m_frame.store(), [&](db::Database& database) -> Trouble {
        const auto record = db::RunRepository(database).find(db::RunId{run});
        if (!record) return text("The run is no longer in the database.");
        recording = record->start.recordingFile;
        return std::nullopt;
    });
    return trouble ? trouble : debriefOf(m_frame, recording);
}

Trouble RosterStore::openResult(std::int64_t run) {
    m_frame.openPage(resultPage(m_frame, db::RunId{run}));
    return std::nullopt;
}

core::Result<roster::Job, QString> RosterStore::reportJob(std::int64_t run, const QString& file) {
    return reportJobOf(m_frame.store(), db::RunId{run}, file);
}

}  // namespace sagara::station
