#include "SimTest.h"
#include "Sqlite.h"

namespace sagara::run::test {
namespace {

namespace fs = std::filesystem;

/// Runs that could not be filed when they were sailed: the database was of a newer Sagara.
class UnfiledRun : public SimTest {
protected:
    void SetUp() override {
        simDone({"list", "runs"});
        Sqlite(database()).execute("PRAGMA user_version = 99");
    }
    void mend() const { Sqlite(database()).execute("PRAGMA user_version = 3"); }
    std::vector<std::string> notes() const {
        std::vector<std::string> notes;
        for (const std::string& name : namesIn(data() / "recordings")) {
            if (name.ends_with(".unfiled")) notes.push_back(name);
        }
        return notes;
    }
};

TEST_F(UnfiledRun, IsNotedBesideTheRecordings) {
    simDone(lesson("2"));
    ASSERT_EQ(notes().size(), 1u);
    const std::string note = bytesOf(data() / "recordings" / notes()[0]);
    EXPECT_EQ(note.rfind("recordings/", 0), 0u) << note;
    EXPECT_TRUE(note.ends_with("-basic-navigation-1.sgr\n")) << note;
    mend();
    simDone(lesson("1"));
    EXPECT_TRUE(notes().empty());
    EXPECT_EQ(linesOf(simDone({"list", "runs"}).out).size(), 2u);
}

TEST_F(UnfiledRun, IsFiledByListingTheRuns) {
    simDone(lesson("2", {"--trainee", "A. Perera"}));
    mend();
    const Outcome list = simDone({"list", "runs"});
    EXPECT_NE(list.out.find("A. Perera"), std::string::npos) << list.out;
    EXPECT_EQ(list.err.rfind("Filed the earlier run recordings/", 0), 0u) << list.err;
    EXPECT_TRUE(notes().empty());
}

TEST_F(UnfiledRun, OfTheSameFileNameInAnotherFolderIsNotForgotten) {
    fs::create_directories(at("a"));
    fs::create_directories(at("b"));
    simDone(lesson("2", {"--record", at("a/run.sgr")}));
    simDone(lesson("3", {"--record", at("b/run.sgr")}));
    mend();
    simDone(lesson("1"));
    const std::string runs = simDone({"list", "runs"}).out;
    EXPECT_NE(runs.find("a/run.sgr"), std::string::npos) << runs;
    EXPECT_NE(runs.find("b/run.sgr"), std::string::npos) << runs;
}

TEST_F(UnfiledRun, WhoseRecordingIsGoneIsToldEachTimeAndStopsNothing) {
    simDone(lesson("2", {"--record", at("gone.sgr")}));
    fs::remove(at("gone.sgr"));
    mend();
    for (int i = 0; i < 2; ++i) {
        const Outcome run = simDone(lesson("1"));
        EXPECT_EQ(run.err.rfind("The earlier run " + at("gone.sgr") +
                                    " still cannot be filed: " + at("gone.sgr") + ": cannot be read",
                                0),
                  0u)
            << run.err;
    }
    EXPECT_EQ(notes().size(), 1u);
}

TEST_F(UnfiledRun, GradeAndTasksAreThoseOfTheRun) {
    const nlohmann::json run = simJson(lesson("150", {"--helm", "pilot"}));
    mend();
    simDone(lesson("1"));
    Sqlite database(this->database());
    auto tasks =
        nlohmann::json::parse(database.value("SELECT tasks FROM grade ORDER BY id LIMIT 1"), nullptr, false);
    for (auto& task : tasks) EXPECT_EQ(task.erase("title"), 1u);  // for people; not in the printed JSON
    EXPECT_EQ(tasks, run["tasks"]);
    EXPECT_EQ(std::stod(database.value("SELECT score FROM grade ORDER BY id LIMIT 1")), run["score"]);
}

TEST_F(UnfiledRun, AKilledRunIsFiledWhenItIsTakenUpAgain) {
    const Outcome whole = simDone(lesson("5", {"--record", at("run.sgr")}));
    const std::string bytes = read("run.sgr");
    for (const std::string& note : notes()) fs::remove(data() / "recordings" / note);
    write("run.sgr", bytes.substr(0, bytes.size() - 1000));
    mend();
    const Outcome resumed = simDone({"run", "--resume", at("run.sgr"), "--fast", "--duration-s", "5"});
    EXPECT_EQ(hashIn(resumed), hashIn(whole));
    EXPECT_EQ(linesOf(simDone({"list", "runs"}).out).size(), 1u);
}

}  // namespace
}  // namespace sagara::run::test
