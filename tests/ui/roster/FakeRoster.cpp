#include "FakeRoster.h"

#include <QFile>
#include <algorithm>

namespace sagara::ui::roster::test {
namespace {

constexpr core::Utc kNow{1800000000};
constexpr std::int64_t kDay_s = 86'400;

Person person(std::int64_t id, const char* name, const char* number, const char* rank, std::int64_t classId,
              Role role = Role::Trainee, const char* note = "") {
    Person p;
    p.id = id;
    p.name = QString::fromUtf8(name);
    p.number = QString::fromUtf8(number);
    p.rank = QString::fromUtf8(rank);
    p.classId = classId;
    p.className = classId == 1   ? QStringLiteral("Watchkeeping 27-A")
                  : classId == 2 ? QStringLiteral("Watchkeeping 27-B")
                                 : QString();
    p.role = role;
    p.note = QString::fromUtf8(note);
    return p;
}

Run run(std::int64_t id, int daysAgo, const char* who, const char* mission, const char* type, int level,
        double score, bool passed, const char* signedBy = "") {
    Run r;
    r.id = id;
    r.started = {kNow.unix_s - daysAgo * kDay_s + 3600 * id};
    r.person = QString::fromUtf8(who);
    r.className = QStringLiteral("Watchkeeping 27-A");
    r.mission = QString::fromUtf8(mission);
    r.type = QString::fromUtf8(type);
    r.level = level;
    r.status = QStringLiteral("finished");
    r.duration_s = 1800 + 61.0 * double(id);
    r.automatic = Score{score, passed};
    r.signedBy = QString::fromUtf8(signedBy);
    return r;
}

Assignment assignment(std::int64_t id, const char* mission, const char* whom, std::int64_t classId, int days,
                      const char* type, State state, std::vector<Member> members) {
    Assignment a;
    a.id = id;
    a.mission = QString::fromUtf8(mission);
    a.forWhom = QString::fromUtf8(whom);
    a.classId = classId;
    a.personId = classId == 0 ? 1 : 0;
    a.due = {kNow.unix_s + days * kDay_s};
    a.created = {kNow.unix_s - 10 * kDay_s};
    a.type = QString::fromUtf8(type);
    a.level = 3;
    a.assignedBy = QStringLiteral("Cdr. A. Silva");
    a.state = state;
    a.members = std::move(members);
    return a;
}

Job copyJob(const QString& file) {
    return [file](JobControl& control) -> QString {
        control.setPercent(50);
        QFile out(file);
        if (!out.open(QIODevice::WriteOnly)) return QStringLiteral("cannot write ") + file;
        out.write("%PDF-");
        return {};
    };
}

}  // namespace

FakeRoster::FakeRoster() {
    m_classes = {{1, QStringLiteral("Watchkeeping 27-A")}, {2, QStringLiteral("Watchkeeping 27-B")}};
    m_people = {
        person(1, "Nimal Perera", "NA-1701", "Midshipman", 1, Role::Trainee, "nimal.perera@academy.example"),
        person(2, "Kamala Fernando", "NA-1702", "Midshipman", 1, Role::Trainee, "kamala.f@academy.example"),
        person(3, "නිරෝෂා ජයසිංහ", "NA-1703", "Midshipman", 1),
        person(4, "R. Sivakumar", "NA-1704", "Sub-Lieutenant", 1, Role::Trainee, "transferred from 26-B"),
        person(5, "Tharindu Bandara", "NA-1705", "Midshipman", 2),
        person(6, "M. O'Brien", "EX-12", "Lieutenant", 2, Role::Trainee, "exchange officer until June"),
        person(7, "Cdr. A. Silva", "NA-0210", "Commander", 0, Role::Trainer, "a.silva@academy.example"),
        person(8, "Lt Cdr. D. Wickramasinghe", "NA-0388", "Lieutenant Commander", 0, Role::Trainer)};
    Person gone = person(9, "S. Dias", "NA-1621", "Midshipman", 0);
    gone.retired = true;
    m_people.push_back(gone);
    m_missions = {{QStringLiteral("basic-navigation"), QStringLiteral("Basic Navigation")},
                  {QStringLiteral("heavy-weather"), QStringLiteral("Heavy Weather")}};
    const core::Utc yesterday{kNow.unix_s - kDay_s};
    m_assignments = {
        assignment(1, "Basic Navigation", "Class Watchkeeping 27-A", 1, -2, "train", State::Late,
                   {{QStringLiteral("Nimal Perera"), State::Done, yesterday},
                    {QStringLiteral("Kamala Fernando"), State::Done, yesterday},
                    {QStringLiteral("නිරෝෂා ජයසිංහ"), State::Late, {}},
                    {QStringLiteral("R. Sivakumar"), State::Late, {}}}),
        assignment(2, "Heavy Weather", "Nimal Perera", 0, 5, "assess", State::Open,
                   {{QStringLiteral("Nimal Perera"), State::Open, {}}}),
        assignment(3, "Basic Navigation", "Class Watchkeeping 27-B", 2, 9, "familiarise", State::Done,
                   {{QStringLiteral("Tharindu Bandara"), State::Done, yesterday},
                    {QStringLiteral("M. O'Brien"), State::Done, yesterday}})};
    m_runs = {run(9, 0, "Nimal Perera", "Basic Navigation", "assess", 3, 82, true),
              run(8, 1, "Kamala Fernando", "Basic Navigation", "assess", 3, 58.5, false),
              run(7, 1, "Nimal Perera", "Basic Navigation", "train", 3, 71, true),
              run(6, 2, "R. Sivakumar", "Heavy Weather", "train", 4, 40, false),
              run(5, 3, "", "Basic Navigation", "self-study", 1, 100, true),
              run(4, 4, "Tharindu Bandara", "Basic Navigation", "familiarise", 2, 66, true, "Cdr. A. Silva")};
    m_runs[1].overruled = Score{72, true};
    m_runs[1].signedBy = QStringLiteral("Cdr. A. Silva");
    m_runs[3].status = QStringLiteral("aborted");
    Run now = run(10, 0, "M. O'Brien", "Heavy Weather", "train", 3, 0, false);
    now.status = QStringLiteral("running");
    now.automatic.reset();
    m_runs.insert(m_runs.begin(), now);
}

void FakeRoster::clear() {
    m_people.clear();
    m_classes.clear();
    m_assignments.clear();
    m_runs.clear();
}

Person* FakeRoster::find(const QString& name) {
    const auto known =
        std::find_if(m_people.begin(), m_people.end(), [&](const Person& p) { return p.name == name; });
    return known == m_people.end() ? nullptr : &*known;
}

std::vector<SchoolClass> FakeRoster::classes() {
    std::vector<SchoolClass> classes;
    for (const auto& [id, name] : m_classes) {
        const auto people = std::count_if(m_people.begin(), m_people.end(), [&, of = id](const Person& p) {
            return p.classId == of && !p.retired;
        });
        classes.push_back({id, name, int(people)});
    }
    return classes;
}

core::Result<std::int64_t, QString> FakeRoster::savePerson(const Person& person) {
    for (Person& p : m_people)
        if (p.id == person.id) return p = person, p.id;
    m_people.push_back(person);
    return m_people.back().id = m_nextId++;
}

Trouble FakeRoster::retirePerson(std::int64_t id, bool retired) {
    for (Person& p : m_people)
        if (p.id == id) p.retired = retired;
    return std::nullopt;
}

Trouble FakeRoster::movePeople(const std::vector<std::int64_t>& ids, const QString& className) {
    for (const std::int64_t id : ids)
        for (Person& p : m_people)
            if (p.id == id) p.className = className;
    return std::nullopt;
}

Trouble FakeRoster::importPeople(const std::vector<Person>& people) {
    if (m_importTrouble) return m_importTrouble;
    for (const Person& p : people) (void)savePerson(p);
    return std::nullopt;
}

Trouble FakeRoster::addClass(const QString& name) { return m_classes[m_nextId++] = name, std::nullopt; }
Trouble FakeRoster::renameClass(std::int64_t id, const QString& name) {
    return m_classes[id] = name, std::nullopt;
}
Trouble FakeRoster::retireClass(std::int64_t id) { return m_classes.erase(id), std::nullopt; }

Trouble FakeRoster::assign(const NewAssignment& a) {
    Assignment made;
    made.id = m_nextId++;
    made.mission = a.mission.name;
    made.personId = a.personId;
    made.classId = a.classId;
    made.forWhom = QStringLiteral("somebody");
    made.due = a.due;
    made.type = a.type;
    made.level = a.level;
    m_assignments.push_back(made);
    return std::nullopt;
}

Trouble FakeRoster::withdraw(std::int64_t id) {
    for (Assignment& a : m_assignments)
        if (a.id == id) a.state = State::Withdrawn;
    return std::nullopt;
}

std::vector<Run> FakeRoster::runs(const RunFilter& filter, int most) {
    std::vector<Run> runs;
    QString name;
    for (const Person& p : m_people)
        if (p.id == filter.personId) name = p.name;
    for (const Run& r : m_runs) {
        const bool fits =
            (filter.personId == 0 || r.person == name) && (filter.type.isEmpty() || r.type == filter.type);
        if (fits && int(runs.size()) < most) runs.push_back(r);
    }
    return runs;
}

core::Result<Job, QString> FakeRoster::reportJob(std::int64_t, const QString& file) { return copyJob(file); }

FakeResult::FakeResult() {
    m_result.mission = QStringLiteral("Basic Navigation");
    m_result.person = QStringLiteral("Kamala Fernando");
    m_result.type = QStringLiteral("assess");
    m_result.started = kNow;
    m_result.duration_s = 2345;
    m_result.automatic = Score{58.5, false};
    m_result.whyNot = QStringLiteral("score 59, 60 needed");
    for (const auto& [title, time_s] : {std::pair{"Cast off from New Pier", 312.0},
                                        {"Leave harbour", 905.0},
                                        {"Follow the route to waypoint 8", 1980.0}})
        m_result.tasks.push_back({QString::fromUtf8(title), true, time_s});
    m_result.tasks.push_back({QStringLiteral("Anchor in the anchorage"), false, 0.0});
    m_result.losses = {
        {402.0, QStringLiteral("Keep to the speeds"), QStringLiteral("kn"), 7.42, 6.0, 8.5, false},
        {1210.0, QStringLiteral("Stay in the corridor"), QStringLiteral("m"), 71.3, 50.0, 13.0, false},
        {1601.0, QStringLiteral("Keep clear of traffic"), QStringLiteral("m"), 185.0, 250.0, 20.0, false}};
    Person silva = person(7, "Cdr. A. Silva", "", "", 0, Role::Trainer);
    m_assessors = {silva};
}

Trouble FakeResult::signOff(const Entry& entry, std::int64_t by) {
    m_result.entry = entry;
    for (const Person& p : m_assessors)
        if (p.id == by) m_result.signedBy = p.name;
    m_result.signedAt = kNow;
    return std::nullopt;
}

core::Result<Job, QString> FakeResult::reportJob(const QString& file) { return copyJob(file); }

}  // namespace sagara::ui::roster::test
