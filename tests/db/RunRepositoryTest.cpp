#include "db/RunRepository.h"

#include <gtest/gtest.h>

#include <limits>

#include "Support.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace test;
using namespace Qt::StringLiterals;

class Runs : public ::testing::Test {
protected:
    TemporaryFolder m_folder;
    Database m_db{m_folder / "sagara.db"};
    RunRepository m_runs{m_db};
};

TEST_F(Runs, StartedRunIsRunningAndHoldsWhatWasGiven) {
    NewRun run = lesson();
    run.person = *PersonRepository(m_db).add("Dias", Role::Trainee, kMorning);
    const RunId id = m_runs.start(run);
    const auto found = m_runs.find(id);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->id, id);
    EXPECT_EQ(found->start.person, run.person);
    EXPECT_EQ(found->start.scenarioKey, "basic-navigation");
    EXPECT_EQ(found->start.scenarioName, "Basic Navigation");
    EXPECT_EQ(found->start.type, RunType::Assess);
    EXPECT_EQ(found->start.level, 3);
    EXPECT_EQ(found->start.seed, 7u);
    EXPECT_EQ(found->start.buildId, "0.1.0");
    EXPECT_EQ(found->start.started, kMorning);
    EXPECT_EQ(found->start.recordingFile, "recordings/a.sagarec");
    EXPECT_EQ(found->status, RunStatus::Running);
    EXPECT_FALSE(found->finished);
    EXPECT_FALSE(found->stateHash);
}

TEST_F(Runs, FinishedRunHoldsItsResultAndEndsOnce) {
    const RunId id = m_runs.start(lesson());
    EXPECT_TRUE(m_runs.finish(id, ended()));
    const RunRecord run = *m_runs.find(id);
    EXPECT_EQ(run.status, RunStatus::Finished);
    EXPECT_EQ(run.finished, kNoon);
    EXPECT_EQ(run.simTime.us, 1'234'560'000);
    EXPECT_EQ(run.stateHash, 0x0123456789abcdefULL);
    RunResult other = ended();
    other.status = RunStatus::Aborted;
    EXPECT_FALSE(m_runs.finish(id, other));
    EXPECT_EQ(m_runs.find(id)->status, RunStatus::Finished);
    EXPECT_FALSE(m_runs.finish(RunId{999}, ended()));
}

TEST_F(Runs, AbortedRunNeedsNoStateHash) {
    const RunId id = m_runs.start(lesson());
    EXPECT_TRUE(m_runs.finish(
        id, {.status = RunStatus::Aborted, .finished = kNoon, .simTime = {20'000}, .stateHash = {}}));
    EXPECT_EQ(m_runs.find(id)->status, RunStatus::Aborted);
    EXPECT_FALSE(m_runs.find(id)->stateHash);
}

TEST_F(Runs, SeedAndStateHashKeepAllSixtyFourBits) {
    for (const std::uint64_t bits :
         {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 63, std::uint64_t{0x7fffffffffffffff},
          std::numeric_limits<std::uint64_t>::max()}) {
        NewRun run = lesson("recordings/" + std::to_string(bits));
        run.seed = bits;
        const RunId id = m_runs.start(run);
        m_runs.finish(id,
                      {.status = RunStatus::Finished, .finished = kNoon, .simTime = {}, .stateHash = bits});
        EXPECT_EQ(m_runs.find(id)->start.seed, bits);
        EXPECT_EQ(m_runs.find(id)->stateHash, bits);
    }
}

TEST_F(Runs, EveryTypeComesBack) {
    for (const RunType type :
         {RunType::Familiarise, RunType::Train, RunType::Assess, RunType::SelfStudy, RunType::Demo}) {
        NewRun run = lesson("recordings/" + std::string(toText(type)));
        run.type = type;
        EXPECT_EQ(m_runs.find(m_runs.start(run))->start.type, type);
        EXPECT_EQ(parseRunType(toText(type)), type);
    }
    EXPECT_FALSE(parseRunType("holiday"));
    EXPECT_EQ(parseRunStatus("aborted"), RunStatus::Aborted);
}

TEST_F(Runs, FoundByRecording) {
    const RunId id = m_runs.start(lesson("recordings/it's \"this\".sagarec"));
    EXPECT_EQ(m_runs.findByRecording("recordings/it's \"this\".sagarec")->id, id);
    EXPECT_FALSE(m_runs.findByRecording("recordings/other.sagarec"));
}

TEST_F(Runs, ListIsNewestFirstAndInPages) {
    for (int i = 0; i < 7; ++i) {
        NewRun run = lesson(std::to_string(i));
        run.started.unix_s += i / 2;  // pairs of equal time: the later id counts as newer
        m_runs.start(run);
    }
    std::string all, pages;
    for (const RunRecord& r : m_runs.list()) all += r.start.recordingFile;
    for (int offset = 0; offset < 9; offset += 3) {
        for (const RunRecord& r : m_runs.list({.limit = 3, .offset = offset})) pages += r.start.recordingFile;
    }
    EXPECT_EQ(all, "6543210");
    EXPECT_EQ(pages, all);
    EXPECT_EQ(m_runs.count(), 7);
}

TEST_F(Runs, TwoRunsMayNotShareARecording) {
    m_runs.start(lesson());
    const DbError error = errorOf([this] { m_runs.start(lesson()); });
    EXPECT_NE(std::string(error.what()).find("run.recording_file"), std::string::npos) << error.what();
    EXPECT_EQ(m_runs.count(), 1);
}

TEST_F(Runs, UnknownPersonIsRefused) {
    NewRun run = lesson();
    run.person = PersonId{12345};
    EXPECT_THROW(m_runs.start(run), DbError);
    EXPECT_EQ(m_runs.count(), 0);
}

TEST_F(Runs, PersonWithRunsCannotBeDeleted) {
    NewRun run = lesson();
    run.person = *PersonRepository(m_db).add("Dias", Role::Trainee, kMorning);
    m_runs.start(run);
    EXPECT_THROW(execute(m_db.connection(), u"DELETE FROM person"_s), DbError);
}

class WrongValue : public Runs, public ::testing::WithParamInterface<const char16_t*> {};
TEST_P(WrongValue, IsRefusedByTheSchema) {
    fileRun(m_db, {lesson(), ended(), good()});
    const auto statement = QString::fromUtf16(GetParam());
    EXPECT_THROW(execute(m_db.connection(), statement), DbError) << statement.toStdString();
}
INSTANTIATE_TEST_SUITE_P(
    Checks, WrongValue,
    ::testing::Values(
        u"UPDATE run SET type = 'holiday'", u"UPDATE run SET level = 6", u"UPDATE run SET level = 0",
        u"UPDATE run SET status = 'lost'", u"UPDATE run SET status = 'running'",
        u"UPDATE run SET finished_utc = NULL", u"UPDATE run SET sim_time_us = -1",
        u"UPDATE run SET state_hash = '1234'", u"UPDATE run SET seed = 'seven'",
        u"UPDATE run SET recording_file = ''", u"UPDATE grade SET score = 100.5",
        u"UPDATE grade SET score = -1", u"UPDATE grade SET passed = 2", u"UPDATE grade SET advisory = 2",
        u"UPDATE grade SET tasks = '[broken'", u"UPDATE grade SET run_id = 99", u"DELETE FROM run",
        u"INSERT INTO person (name, role, created_utc) VALUES ('x', 'captain', '2027-01-15T03:30:00Z')",
        u"INSERT INTO person (name, role, created_utc) VALUES ('', 'admin', '2027-01-15T03:30:00Z')",
        u"INSERT INTO vessel (key, name, document, content_hash, origin, changed_utc) "
        "VALUES ('a', 'a', '{}', '0123456789abcdef', 'found', '')",
        u"INSERT INTO document_history (document_table, key, content_hash, document, replaced_utc) "
        "VALUES ('person', 'a', '0123456789abcdef', '', '')"));

}  // namespace
}  // namespace sagara::db
