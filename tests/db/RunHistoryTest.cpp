#include "db/RunHistory.h"

#include <gtest/gtest.h>

#include "Support.h"
#include "db/AssessmentRepository.h"

namespace sagara::db {
namespace {

using namespace test;

class History : public ::testing::Test {
protected:
    PersonId person(const char* name, std::optional<ClassId> schoolClass = {}, Role role = Role::Trainee) {
        NewPerson p;
        p.name = name;
        p.role = role;
        p.schoolClass = schoolClass;
        return *m_people.add(p, kMorning);
    }
    RunId sail(PersonId who, RunType type, const char* scenario = "basic-navigation") {
        NewRun run = lesson("recordings/" + std::to_string(++m_runs));
        run.person = who;
        run.type = type;
        run.scenarioKey = scenario;
        run.started.unix_s += m_runs;
        return fileRun(m_db, {run, ended(), good()});
    }
    TemporaryFolder m_folder;
    Database m_db{m_folder / "sagara.db"};
    PersonRepository m_people{m_db};
    ClassId m_watch = *ClassRepository(m_db).add("Watch A", kMorning);
    PersonId m_silva = person("Silva", m_watch), m_dias = person("Dias");
    RunHistory m_history{m_db};
    int m_runs = 0;
};

TEST_F(History, OnlyAssessCountsAsAGrade) {
    for (const RunType type :
         {RunType::Familiarise, RunType::Train, RunType::Assess, RunType::SelfStudy, RunType::Demo})
        sail(m_silva, type);
    NewRun ungraded = lesson("recordings/ungraded");
    ungraded.person = m_silva;
    RunRepository(m_db).start(ungraded);
    const auto grades = m_history.gradesOf(m_silva);
    ASSERT_EQ(grades.size(), 1u);
    EXPECT_EQ(grades[0].type, RunType::Assess);
    const auto practice = m_history.practiceOf(m_silva);
    ASSERT_EQ(practice.size(), 3u);
    EXPECT_EQ(practice[0].type, RunType::SelfStudy);
    EXPECT_TRUE(m_history.gradesOf(m_dias).empty());
}

TEST_F(History, IsFilteredByPersonClassScenarioAndType) {
    sail(m_silva, RunType::Assess);
    sail(m_silva, RunType::Train, "anchoring");
    sail(m_dias, RunType::Train);
    RunRepository(m_db).start(lesson("recordings/nobody"));
    EXPECT_EQ(m_history.count(), 4);
    RunFilter filter;
    filter.person = m_silva;
    EXPECT_EQ(m_history.count(filter), 2);
    filter.type = RunType::Train;
    ASSERT_EQ(m_history.list(filter).size(), 1u);
    EXPECT_EQ(m_history.list(filter)[0].scenarioKey, "anchoring");
    EXPECT_EQ(m_history.count({.person = {}, .schoolClass = m_watch, .scenarioKey = "", .type = {}}), 2);
    EXPECT_EQ(m_history.count({.person = {}, .schoolClass = {}, .scenarioKey = "anchoring", .type = {}}), 1);
    EXPECT_EQ(m_history.list({}, {.limit = 2, .offset = 1}).size(), 2u);
}

TEST_F(History, TellsWhoWhatAndTheAssessorsResult) {
    const RunId run = sail(m_silva, RunType::Assess);
    RunLine line = m_history.find(run).value();
    EXPECT_EQ(line.personName, "Silva");
    EXPECT_EQ(line.className, "Watch A");
    EXPECT_EQ(line.valid(), (ScoreAndPass{87.5, true}));
    EXPECT_EQ(line.signedBy, "");
    AssessmentRepository assessments(m_db);
    ASSERT_TRUE(assessments.put(run, {"", Overrule{40.0, false, "unsafe speed"}}, kNoon));
    ASSERT_TRUE(assessments.sign(run, person("Trainer", {}, Role::Trainer), kNoon));
    line = m_history.find(run).value();
    EXPECT_EQ(line.automatic, (ScoreAndPass{87.5, true}));
    EXPECT_EQ(line.valid(), (ScoreAndPass{40.0, false}));
    EXPECT_EQ(line.signedBy, "Trainer");
    EXPECT_EQ(line.signedAt, kNoon);
}

TEST_F(History, ShowsRunsOfNobodyAndUngradedOnes) {
    const RunId run = RunRepository(m_db).start(lesson());
    const RunLine line = m_history.find(run).value();
    EXPECT_FALSE(line.person);
    EXPECT_EQ(line.personName, "");
    EXPECT_FALSE(line.valid());
    EXPECT_FALSE(m_history.find(RunId{99}));
}

}  // namespace
}  // namespace sagara::db
