#include "SimTest.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::run::test {
namespace {

/// Half a minute of the lesson under the pilot, recorded.
class Replay : public SimTest {
protected:
    void SetUp() override {
        m_run = simJson(lesson("30", {"--helm", "pilot", "--seed", "7", "--record", at("run.sgr")}));
    }
    nlohmann::json m_run;
};

TEST_F(Replay, EndsWithTheSameHash) {
    EXPECT_EQ(hashIn(simDone({"replay", at("run.sgr")})), m_run["state_hash"]);
}

TEST_F(Replay, GivesTheSameSummary) {
    nlohmann::json again = simJson({"replay", at("run.sgr")});
    EXPECT_EQ(again["graded_from"], "the run itself, to the bit");
    for (const char* key : {"wall_time_s", "graded_from"}) {
        again.erase(key);
        m_run.erase(key);
    }
    EXPECT_EQ(again, m_run);
}

TEST_F(Replay, StopsWhereAskedTo) {
    const nlohmann::json part = simJson({"replay", at("run.sgr"), "--until-s", "10"});
    EXPECT_EQ(part["sim_time_s"], 10.0);
    EXPECT_NE(part["state_hash"], m_run["state_hash"]);
    const nlohmann::json whole = simJson({"replay", at("run.sgr"), "--until-s", "9999"});
    EXPECT_EQ(whole["state_hash"], m_run["state_hash"]);
    EXPECT_EQ(simJson({"replay", at("run.sgr"), "--until-s", "0"})["sim_time_s"], 0.0);
}

TEST_F(Replay, IsTheSameWithoutTheDocumentsOfThisDatabase) {
    std::filesystem::remove_all(data());
    EXPECT_EQ(hashIn(simDone({"replay", at("run.sgr")})), m_run["state_hash"]);
    EXPECT_FALSE(std::filesystem::exists(data()));  // a replay needs no database
}

TEST_F(Replay, WritesAReport) {
    simDone({"replay", at("run.sgr"), "--report", at("report.pdf")});
    EXPECT_EQ(read("report.pdf").rfind("%PDF-", 0), 0u);
}

TEST_F(Replay, AStricterRubricCostsMore) {
    nlohmann::json rubric{{"document", "rubric"}, {"version", 1}, {"scenario", "basic-navigation"}};
    rubric["mission"] = nlohmann::json::parse(sagara::test::lessonText())["mission"];
    for (nlohmann::json& criterion : rubric["mission"]["criteria"]) {
        if (criterion["id"] == "under-keel") criterion["limit_m"] = 15.0;  // more than the harbour is deep
    }
    write("strict.json", rubric.dump());
    const nlohmann::json graded = simJson({"replay", at("run.sgr"), "--rubric", at("strict.json")});
    EXPECT_LT(graded["score"], m_run["score"]);
    ASSERT_FALSE(graded["deductions"].empty());
    EXPECT_EQ(graded["deductions"][0]["id"], "under-keel");
    EXPECT_EQ(graded["deductions"][0]["limit"], 15.0);
    EXPECT_EQ(graded["state_hash"], m_run["state_hash"]);  // the run is the same
}

TEST_F(Replay, ARubricWithFaultsIsRefusedWithAllOfThem) {
    nlohmann::json rubric{{"document", "rubric"}, {"version", 1}, {"scenario", "basic-navigation"}};
    rubric["mission"] = nlohmann::json::parse(sagara::test::lessonText())["mission"];
    rubric["mission"]["passScore"] = "much";
    rubric["mission"]["criteria"][0]["wieght"] = 3;
    write("faulty.json", rubric.dump());
    const Outcome replay =
        sim({"replay", at("run.sgr"), "--rubric", at("faulty.json"), "--track", at("t.csv")});
    EXPECT_EQ(replay.exitCode, 2);
    EXPECT_EQ(replay.out, "");
    EXPECT_NE(replay.err.find("mission.passScore is \"much\", expected "), std::string::npos) << replay.err;
    EXPECT_NE(replay.err.find("mission.criteria[0].wieght is unknown"), std::string::npos) << replay.err;
    EXPECT_FALSE(std::filesystem::exists(at("t.csv")));
}

}  // namespace
}  // namespace sagara::run::test
