#include "db/FileRun.h"

#include <gtest/gtest.h>

#include "Support.h"

namespace sagara::db {
namespace {

using namespace test;

class Filing : public ::testing::Test {
protected:
    TemporaryFolder m_folder;
    Database m_db{m_folder / "sagara.db"};
    RunRepository m_runs{m_db};
    GradeRepository m_grades{m_db};
};

TEST_F(Filing, StoresRunResultAndGradeTogether) {
    const RunId id = fileRun(m_db, {lesson(), ended(), good()});
    EXPECT_EQ(m_runs.find(id)->status, RunStatus::Finished);
    EXPECT_EQ(m_grades.find(id), good());
}

TEST_F(Filing, TheSameRecordingAgainChangesNothing) {
    const RunId id = fileRun(m_db, {lesson(), ended(), good()});
    NewRun other = lesson();
    other.scenarioName = "Other";
    Grade worse = good();
    worse.score = 1;
    EXPECT_EQ(fileRun(m_db, {other, ended(), worse}), id);
    EXPECT_EQ(m_runs.count(), 1);
    EXPECT_EQ(m_runs.find(id)->start.scenarioName, "Basic Navigation");
    EXPECT_EQ(m_grades.find(id), good());
}

TEST_F(Filing, ARecordingThatReplacedAnotherRunsIsFiledAsARunOfItsOwn) {
    const RunId first = fileRun(m_db, {lesson(), ended(), good()});
    NewRun other = lesson();
    other.started = kNoon;
    const RunId second = fileRun(m_db, {other, ended(), good()});
    EXPECT_NE(second, first);
    EXPECT_EQ(m_runs.find(first)->start.recordingFile, "recordings/a.sagarec (replaced, run 1)");
    EXPECT_EQ(m_runs.findByRecording("recordings/a.sagarec")->id, second);
    EXPECT_EQ(fileRun(m_db, {other, ended(), good()}), second);
    const RunId third = beginRun(m_db, other);  // even within the same second
    EXPECT_EQ(m_runs.findByRecording("recordings/a.sagarec")->id, third);
    EXPECT_EQ(m_runs.count(), 3);
}

TEST_F(Filing, CompletesARunWhoseEndCouldNotBeStored) {
    const RunId id = m_runs.start(lesson());
    EXPECT_EQ(fileRun(m_db, {lesson(), ended(), good()}), id);
    EXPECT_EQ(m_runs.find(id)->status, RunStatus::Finished);
    EXPECT_TRUE(m_grades.find(id));
}

TEST_F(Filing, AddsTheGradeThatIsMissing) {
    const RunId id = fileRun(m_db, {lesson(), ended(), {}});
    EXPECT_FALSE(m_grades.find(id));
    fileRun(m_db, {lesson(), ended(), good()});
    EXPECT_EQ(m_grades.find(id), good());
}

TEST_F(Filing, NothingIsStoredWhenTheGradeIsRefused) {
    Grade impossible = good();
    impossible.score = 101;
    EXPECT_THROW(fileRun(m_db, {lesson(), ended(), impossible}), DbError);
    EXPECT_EQ(m_runs.count(), 0);
}

TEST_F(Filing, GradePutAgainReplacesTheFirst) {
    const RunId id = m_runs.start(lesson());
    m_grades.put(id, good());
    Grade byTrainer = good();
    byTrainer.score = 60;
    byTrainer.advisory = false;
    m_grades.put(id, byTrainer);
    EXPECT_EQ(m_grades.find(id), byTrainer);
    EXPECT_FALSE(m_grades.find(RunId{99}));
}

TEST_F(Filing, AutomaticGradeIsAdvisoryUnlessSaidOtherwise) { EXPECT_TRUE(Grade{}.advisory); }

}  // namespace
}  // namespace sagara::db
