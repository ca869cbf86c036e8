#include "SimTest.h"
#include "Sqlite.h"

namespace sagara::run::test {
namespace {

namespace fs = std::filesystem;

/// A database with one run in it, then trouble. In each, the exercise is sailed all the same, says what is
/// the matter, keeps its recording and files it at a later start.
class DatabaseTrouble : public SimTest {
protected:
    void SetUp() override {
        simDone(lesson("1"));
        m_hash = hashIn(simDone(lesson("5", {"--seed", "4", "--record", at("whole.sgr")})));
    }
    /// The run goes on without its database; `message` is what it says of it.
    void expectSailedUnfiled(const Outcome& run, const std::string& message) const {
        EXPECT_EQ(run.exitCode, 0) << run.err;
        EXPECT_EQ(hashIn(run), m_hash);
        EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
        EXPECT_NE(
            run.err.find("The run is kept in " + at("late.sgr") + " and will be filed at a later start."),
            std::string::npos)
            << run.err;
        EXPECT_EQ(hashIn(simDone({"replay", at("late.sgr")})), m_hash);
    }
    Outcome sailLate(const std::function<void()>& before = {}) const {
        return sim(lesson("5", {"--seed", "4", "--trainee", "A. Perera", "--record", at("late.sgr")}),
                   before);
    }
    /// Well again: the next start files it, once.
    void expectFiledLater() const {
        const Outcome next = simDone(lesson("1"));
        EXPECT_EQ(next.err, "Filed the earlier run " + at("late.sgr") + ".\n");
        EXPECT_EQ(simDone(lesson("1")).err, "");
        int found = 0;
        for (const std::string& line : linesOf(simDone({"list", "runs"}).out)) {
            if (line.find("late.sgr") == std::string::npos) continue;
            ++found;
            EXPECT_NE(line.find("A. Perera"), std::string::npos) << line;
            EXPECT_NE(line.find("finished"), std::string::npos) << line;
        }
        EXPECT_EQ(found, 1);
        Sqlite database(this->database());
        EXPECT_EQ(database.value("SELECT state_hash FROM run WHERE recording_file LIKE '%late.sgr'"), m_hash);
    }
    std::string m_hash;
};

TEST_F(DatabaseTrouble, LockedByAnotherProgram) {
    Outcome run;
    {
        Sqlite other(database());
        other.execute("BEGIN EXCLUSIVE");
        run = sailLate();
        other.execute("ROLLBACK");
    }
    expectSailedUnfiled(run, "another program kept the database locked for 5 s");
    expectFiledLater();
}

TEST_F(DatabaseTrouble, LockedFromTheMiddleOfTheRunOn) {
    Sqlite other(database());
    Program run(withData({"run", "--scenario", "basic-navigation", "--duration-s", "2", "--seed", "4",
                          "--record", at("late.sgr")}),
                m_folder);
    ASSERT_TRUE(
        happens([&] { return other.value("SELECT count(*) FROM run WHERE status = 'running'") == "1"; }));
    other.execute("BEGIN EXCLUSIVE");
    const Outcome ended = run.wait();
    other.execute("ROLLBACK");
    EXPECT_EQ(ended.exitCode, 0);
    EXPECT_NE(ended.err.find("another program kept the database locked"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("The run is kept in " + at("late.sgr")), std::string::npos) << ended.err;
    EXPECT_EQ(simDone(lesson("1")).err, "Filed the earlier run " + at("late.sgr") + ".\n");
    EXPECT_EQ(other.value("SELECT count(*) FROM run WHERE status = 'running'"), "0");
}

TEST_F(DatabaseTrouble, DamagedFile) {
    const std::string healthy = bytesOf(database());
    std::string damaged = healthy;
    for (std::size_t i = 4096; i < 3 * 4096; ++i) damaged[i] = static_cast<char>(damaged[i] ^ 0x5a);
    write("data/sagara.db", damaged);
    const Outcome run = sailLate();
    expectSailedUnfiled(run, "sagara.db: is damaged: ");
    EXPECT_TRUE(bytesOf(database()) == damaged);
    write("data/sagara.db", healthy);
    expectFiledLater();
}

TEST_F(DatabaseTrouble, NoDatabaseAtAll) {
    const std::string healthy = bytesOf(database());
    write("data/sagara.db", "Dear diary");
    const Outcome run = sailLate();
    expectSailedUnfiled(run, "sagara.db: ");
    EXPECT_EQ(bytesOf(database()), "Dear diary");
    write("data/sagara.db", healthy);
    expectFiledLater();
}

TEST_F(DatabaseTrouble, CutFile) {
    const std::string healthy = bytesOf(database());
    const std::string cut = healthy.substr(0, healthy.size() / 2 + 100);
    write("data/sagara.db", cut);
    const Outcome run = sailLate();
    expectSailedUnfiled(run, "sagara.db: ");
    EXPECT_TRUE(bytesOf(database()) == cut);
    write("data/sagara.db", healthy);
    expectFiledLater();
}

TEST_F(DatabaseTrouble, WrittenByANewerVersion) {
    Sqlite(database()).execute("PRAGMA user_version = 99");
    const std::string newer = bytesOf(database());
    const Outcome run = sailLate();
    expectSailedUnfiled(run,
                        "was written by a newer Sagara: has schema version 99, this program reads 1 to ");
    EXPECT_TRUE(bytesOf(database()) == newer);
    Sqlite(database()).execute("PRAGMA user_version = 3");
    expectFiledLater();
}

TEST_F(DatabaseTrouble, ReadOnlyFile) {
    fs::permissions(database(), fs::perms(0444));
    const std::string before = bytesOf(database());
    const Outcome run = sailLate(giveUpRightsOfRoot);
    expectSailedUnfiled(run, "sagara.db: may not be written. Give this user the right to write");
    EXPECT_TRUE(bytesOf(database()) == before);
    fs::permissions(database(), fs::perms(0644));
    expectFiledLater();
}

TEST_F(DatabaseTrouble, ReadOnlyFolderIsRefusedBecauseNoRecordingCouldBeKept) {
    const std::string before = bytesOf(database());
    fs::permissions(data(), fs::perms(0555));
    const Outcome run = sailLate(giveUpRightsOfRoot);
    fs::permissions(data(), fs::perms(0755));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err,
              data().string() + " may not be written, expected a folder where this user may make files\n");
    EXPECT_TRUE(bytesOf(database()) == before);
    EXPECT_FALSE(fs::exists(at("late.sgr")));
}

TEST_F(DatabaseTrouble, AChangedDocumentIsToldAndNotUsed) {
    Sqlite(database()).execute("UPDATE vessel SET document = replace(document, '51.5', '99.5')");
    const std::string before = bytesOf(database());
    const Outcome run = sailLate();
    EXPECT_EQ(run.signal, 0);
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(linesOf(run.err).size(), 1u) << run.err;
    EXPECT_NE(run.err.find("sagara.db: "), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("patrol51"), std::string::npos) << run.err;
    EXPECT_TRUE(bytesOf(database()) == before);
}

TEST_F(DatabaseTrouble, TheOtherCommandsSaySoAndLeaveItAlone) {
    Sqlite(database()).execute("PRAGMA user_version = 99");
    const std::string newer = bytesOf(database());
    for (const Arguments& arguments :
         {Arguments{"list", "runs"}, Arguments{"list", "vessels"}, Arguments{"backup", at("copy.db")}}) {
        const Outcome outcome = sim(arguments);
        EXPECT_EQ(outcome.exitCode, 1) << arguments[0];
        EXPECT_EQ(outcome.out, "");
        EXPECT_NE(outcome.err.find("was written by a newer Sagara"), std::string::npos) << outcome.err;
    }
    EXPECT_FALSE(fs::exists(at("copy.db")));
    EXPECT_TRUE(bytesOf(database()) == newer);
}

}  // namespace
}  // namespace sagara::run::test
