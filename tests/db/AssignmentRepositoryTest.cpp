#include "db/AssignmentRepository.h"

#include <gtest/gtest.h>

#include "Support.h"
#include "db/AssignmentProgress.h"

namespace sagara::db {
namespace {

using namespace test;

constexpr core::Utc kTomorrow{kNoon.unix_s + 86'400};

class Assignments : public ::testing::Test {
protected:
    PersonId person(const char* name, std::optional<ClassId> schoolClass = {}) {
        NewPerson p;
        p.name = name;
        p.schoolClass = schoolClass;
        return *m_people.add(p, kMorning);
    }
    NewAssignment mission(std::variant<PersonId, ClassId> whom) const {
        NewAssignment m;
        m.scenarioKey = "basic-navigation";
        m.scenarioName = "Basic Navigation";
        m.forWhom = whom;
        m.due = kTomorrow;
        m.type = RunType::Assess;
        m.level = 3;
        return m;
    }
    AssignmentId given(const NewAssignment& m, core::Utc now = kMorning) {
        return *m_assignments.add(m, now);
    }
    void sail(PersonId who, const std::function<void(NewRun&)>& change = {},
              RunStatus status = RunStatus::Finished) {
        NewRun run = lesson("recordings/" + std::to_string(++m_runs));
        run.person = who;
        run.started = kNoon;
        if (change) change(run);
        RunResult result = ended();
        result.status = status;
        result.finished = {run.started.unix_s + 600};
        fileRun(m_db, {run, result, good()});
    }
    AssignmentProgress progress(core::Utc now = kNoon) const { return assignmentProgress(m_db, now).at(0); }

    TemporaryFolder m_folder;
    mutable Database m_db{m_folder / "sagara.db"};
    PersonRepository m_people{m_db};
    ClassRepository m_classes{m_db};
    AssignmentRepository m_assignments{m_db};
    int m_runs = 0;
};

TEST_F(Assignments, ComeBackAsTheyWereGiven) {
    NewAssignment m = mission(person("Silva"));
    m.assignedBy = person("Trainer");
    const AssignmentId id = given(m);
    const AssignmentRecord record = m_assignments.find(id).value();
    EXPECT_EQ(record.what.scenarioName, "Basic Navigation");
    EXPECT_EQ(record.what.forWhom, m.forWhom);
    EXPECT_EQ(record.what.due, kTomorrow);
    EXPECT_EQ(record.what.type, RunType::Assess);
    EXPECT_EQ(record.what.level, 3);
    EXPECT_EQ(record.what.assignedBy, m.assignedBy);
    EXPECT_EQ(record.created, kMorning);
    EXPECT_FALSE(record.withdrawn);
}

TEST_F(Assignments, WhatCannotBeAssignedIsRefused) {
    const PersonId silva = person("Silva");
    NewAssignment m = mission(silva);
    m.due = kMorning;
    EXPECT_EQ(m_assignments.add(m, kMorning).error(), AssignError::DueInThePast);
    m = mission(silva);
    m.level = 6;
    EXPECT_EQ(m_assignments.add(m, kMorning).error(), AssignError::LevelUnknown);
    m = mission(silva);
    m.type = RunType::Demo;
    EXPECT_EQ(m_assignments.add(m, kMorning).error(), AssignError::TypeUnknown);
    m = mission(silva);
    m.scenarioKey.clear();
    EXPECT_EQ(m_assignments.add(m, kMorning).error(), AssignError::ScenarioEmpty);
    EXPECT_TRUE(m_assignments.list().empty());
}

TEST_F(Assignments, OpenOnesOfAPersonAreTheirOwnAndTheirClassesTheEarliestDueFirst) {
    const ClassId watch = *m_classes.add("Watch A", kMorning);
    const PersonId silva = person("Silva", watch), dias = person("Dias");
    NewAssignment later = mission(silva);
    later.due.unix_s += 3600;
    const AssignmentId own = given(later), shared = given(mission(watch)), other = given(mission(dias));
    const auto open = m_assignments.openFor(silva);
    ASSERT_EQ(open.size(), 2u);
    EXPECT_EQ(open[0].id, shared);
    EXPECT_EQ(open[1].id, own);
    EXPECT_EQ(m_assignments.openFor(dias).at(0).id, other);
    EXPECT_TRUE(m_assignments.openFor(PersonId{99}).empty());
}

TEST_F(Assignments, WithdrawnOnesAreNoLongerOpen) {
    const PersonId silva = person("Silva");
    const AssignmentId id = given(mission(silva));
    EXPECT_TRUE(m_assignments.withdraw(id, kNoon));
    EXPECT_FALSE(m_assignments.withdraw(id, kNoon));
    EXPECT_TRUE(m_assignments.openFor(silva).empty());
    EXPECT_EQ(m_assignments.find(id)->withdrawn, kNoon);
}

TEST_F(Assignments, ARunOfThatScenarioTypeAndLevelFulfils) {
    const PersonId silva = person("Silva");
    given(mission(silva));
    sail(silva);
    EXPECT_TRUE(m_assignments.openFor(silva).empty());
    EXPECT_EQ(progress().state, AssignmentState::Done);
    EXPECT_EQ(progress().members.at(0).done, (core::Utc{kNoon.unix_s + 600}));
}

TEST_F(Assignments, AHarderLevelFulfilsToo) {
    const PersonId silva = person("Silva");
    given(mission(silva));
    sail(silva, [](NewRun& run) { run.level = 5; });
    EXPECT_TRUE(m_assignments.openFor(silva).empty());
}

TEST_F(Assignments, OtherRunsDoNotFulfil) {
    const PersonId silva = person("Silva"), dias = person("Dias");
    given(mission(silva));
    sail(silva, [](NewRun& run) { run.level = 2; });
    sail(silva, [](NewRun& run) { run.type = RunType::Train; });
    sail(silva, [](NewRun& run) { run.scenarioKey = "anchoring"; });
    sail(silva, [](NewRun& run) { run.started = {kMorning.unix_s - 1}; });
    sail(silva, {}, RunStatus::Aborted);
    sail(dias);
    EXPECT_EQ(m_assignments.openFor(silva).size(), 1u);
    EXPECT_EQ(progress().state, AssignmentState::Open);
}

TEST_F(Assignments, AreLateWhenTheDateIsBehindAndSomebodyHasNotSailed) {
    const ClassId watch = *m_classes.add("Watch A", kMorning);
    const PersonId silva = person("Silva", watch);
    person("Dias", watch);
    given(mission(watch));
    sail(silva);
    EXPECT_EQ(progress(kTomorrow).state, AssignmentState::Open);
    const AssignmentProgress late = progress({kTomorrow.unix_s + 1});
    EXPECT_EQ(late.state, AssignmentState::Late);
    EXPECT_EQ(late.done(), 1);
    EXPECT_EQ(late.members.at(0).person.name, "Dias");
    EXPECT_EQ(late.members.at(0).state, AssignmentState::Late);
    EXPECT_EQ(late.members.at(1).state, AssignmentState::Done);
}

TEST_F(Assignments, AClassWithoutPeopleIsOpen) {
    given(mission(*m_classes.add("Watch A", kMorning)));
    EXPECT_EQ(progress({kTomorrow.unix_s + 1}).state, AssignmentState::Open);
}

}  // namespace
}  // namespace sagara::db
