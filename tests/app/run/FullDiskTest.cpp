#include "SimTest.h"
#include "Sqlite.h"

namespace sagara::run::test {
namespace {

namespace fs = std::filesystem;

class FullDisk : public SimTest {
protected:
    std::size_t someSecondsOfARecording() const {
        simDone(lesson("1", {"--record", at("first.sgr")}));
        return fs::file_size(at("first.sgr")) + 20'000;
    }
};

TEST_F(FullDisk, UnderTheRecordingIsToldAndTheRunGoesOn) {
    const std::string hash = hashIn(simDone(lesson("60")));
    const std::size_t limit = someSecondsOfARecording();
    const Outcome run = sim(lesson("60", {"--record", at("run.sgr")}), [=] { limitFileSize(limit); });
    EXPECT_EQ(run.signal, 0);
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_EQ(hashIn(run), hash);
    EXPECT_NE(run.err.find("run.sgr: the recording cannot be written ("), std::string::npos) << run.err;
    const Outcome replay = simDone({"replay", at("run.sgr")});
    EXPECT_NE(replay.err.find("; what is whole, up to 00:"), std::string::npos) << replay.err;
    EXPECT_EQ(hashIn(simDone({"run", "--resume", at("run.sgr"), "--fast", "--duration-s", "60"})), hash);
}

TEST_F(FullDisk, FromTheFirstByteOnIsTold) {
    const Outcome run = sim(lesson("2", {"--record", "/dev/full"}));
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.err.find("/dev/full: the recording cannot be written (No space left on device)"),
              std::string::npos)
        << run.err;
    EXPECT_EQ(hashIn(run).size(), 16u);
}

TEST_F(FullDisk, UnderANewDatabaseLeavesNoHalfOfOne) {
    const Outcome run = sim(lesson("2", {"--record", "/dev/null"}), [] { limitFileSize(20'000); });
    EXPECT_EQ(run.signal, 0);
    EXPECT_NE(run.err.find("sagara.db"), std::string::npos) << run.err;
    EXPECT_EQ(linesOf(simDone({"list", "scenarios"}).out).size(), 2u);  // well again
}

TEST_F(FullDisk, UnderTheDatabaseIsToldAndTheRunFiledLater) {
    const std::size_t limit = someSecondsOfARecording();
    Sqlite reader(database()), writer(database());
    reader.execute("BEGIN");
    reader.value("SELECT count(*) FROM setting");  // so that the log cannot begin afresh
    writer.execute("INSERT INTO setting VALUES ('big', printf('%.*c', 4000000, 'x'))");  // into the log
    const Outcome run = sim(lesson("2", {"--record", at("late.sgr")}), [=] { limitFileSize(limit); });
    reader.execute("ROLLBACK");
    EXPECT_EQ(run.exitCode, 0);
    EXPECT_EQ(hashIn(run).size(), 16u);
    EXPECT_NE(run.err.find("sagara.db: "), std::string::npos) << run.err;
    EXPECT_NE(run.err.find("The run is kept in " + at("late.sgr")), std::string::npos) << run.err;
    EXPECT_EQ(writer.value("PRAGMA integrity_check"), "ok");
    EXPECT_EQ(simDone(lesson("1")).err, "Filed the earlier run " + at("late.sgr") + ".\n");
}

TEST_F(FullDisk, UnderTrackAndReportLeavesNoHalfOfThem) {
    simDone(lesson("1"));
    const Outcome run = sim(
        lesson("120", {"--track", at("track.csv"), "--report", at("report.pdf"), "--record", "/dev/null"}),
        [] { limitFileSize(8'000); });
    EXPECT_EQ(run.signal, 0);
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.err.find("track.csv: cannot be written (File too large)"), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(at("track.csv")));
    EXPECT_FALSE(fs::exists(at("track.csv.new")));
    EXPECT_FALSE(fs::exists(at("report.pdf")));
}

}  // namespace
}  // namespace sagara::run::test
