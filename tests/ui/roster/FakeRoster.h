#pragma once

#include <map>

#include "ui/roster/RosterPort.h"

namespace sagara::ui::roster::test {

/// Records in memory, made up; keeps what it was asked to do.
class FakeRoster final : public RosterPort {
public:
    FakeRoster();

    QString trouble() const override { return m_trouble; }
    core::Utc now() const override { return {1800000000}; }
    std::vector<Person> people() override { return m_people; }
    std::vector<SchoolClass> classes() override;
    std::vector<Mission> missions() override { return m_missions; }
    core::Result<std::int64_t, QString> savePerson(const Person& person) override;
    Trouble retirePerson(std::int64_t id, bool retired) override;
    Trouble movePeople(const std::vector<std::int64_t>& ids, const QString& className) override;
    Trouble importPeople(const std::vector<Person>& people) override;
    Trouble addClass(const QString& name) override;
    Trouble renameClass(std::int64_t id, const QString& name) override;
    Trouble retireClass(std::int64_t id) override;
    std::vector<Assignment> assignments() override { return m_assignments; }
    Trouble assign(const NewAssignment& assignment) override;
    Trouble withdraw(std::int64_t id) override;
    std::vector<Run> runs(const RunFilter& filter, int most) override;
    int runCount(const RunFilter& filter) override { return int(runs(filter, 1 << 30).size()); }
    Record recordOf(std::int64_t) override { return {2, 1, 3}; }
    Trouble openDebrief(std::int64_t run) override { return m_opened = run, std::nullopt; }
    Trouble openResult(std::int64_t run) override { return m_opened = run, std::nullopt; }
    core::Result<Job, QString> reportJob(std::int64_t run, const QString& file) override;

    void clear();
    Person* find(const QString& name);

    QString m_trouble;
    std::vector<Person> m_people;
    std::map<std::int64_t, QString> m_classes;
    std::vector<Mission> m_missions;
    std::vector<Assignment> m_assignments;
    std::vector<Run> m_runs;
    std::int64_t m_opened = 0;
    Trouble m_importTrouble;
    std::int64_t m_nextId = 100;
};

/// One result, likewise.
class FakeResult final : public ResultPort {
public:
    FakeResult();
    Result result() override { return m_result; }
    std::vector<Person> assessors() override { return m_assessors; }
    Trouble save(const Entry& entry) override { return m_result.entry = entry, std::nullopt; }
    Trouble signOff(const Entry& entry, std::int64_t by) override;
    Trouble openDebrief() override { return m_debriefs++, std::nullopt; }
    core::Result<Job, QString> reportJob(const QString& file) override;

    Result m_result;
    std::vector<Person> m_assessors;
    int m_debriefs = 0;
};

}  // namespace sagara::ui::roster::test
