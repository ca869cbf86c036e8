#include "SimTest.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::run::test {
namespace {

class RunOptions : public SimTest {};

TEST_F(RunOptions, SameScenarioSeedAndCommandsGiveTheSameHashAnotherSeedAnother) {
    const std::string one = hashIn(simDone(lesson("5", {"--seed", "1"})));
    EXPECT_EQ(hashIn(simDone(lesson("5"))), one);  // 1 is the default
    EXPECT_NE(hashIn(simDone(lesson("5", {"--seed", "18446744073709551615"}))), one);
}

TEST_F(RunOptions, LevelsDifferAndThreeIsTheDefault) {
    const std::string three = hashIn(simDone(lesson("5", {"--level", "3"})));
    EXPECT_EQ(hashIn(simDone(lesson("5"))), three);
    EXPECT_NE(hashIn(simDone(lesson("5", {"--level", "1"}))), three);
    EXPECT_NE(hashIn(simDone(lesson("5", {"--level", "5"}))), three);
}

TEST_F(RunOptions, NobodySailsUnlessThePilotIsAskedTo) {
    const std::string nobody = hashIn(simDone(lesson("10")));
    EXPECT_EQ(hashIn(simDone(lesson("10", {"--helm", "none"}))), nobody);
    EXPECT_NE(hashIn(simDone(lesson("10", {"--helm", "pilot"}))), nobody);
}

TEST_F(RunOptions, CommandsAreCarriedOutAtTheirTime) {
    write("orders.json",
          R"({"document": "commands", "version": 1, "scenario": "basic-navigation",
        "commands": [{"time_s": 3, "order": "helm", "rudder_deg": 20}, {"time_s": 8, "order": "finish"}]})");
    const nlohmann::json run =
        simJson(lesson("60", {"--commands", at("orders.json"), "--track", at("track.csv")}));
    EXPECT_NEAR(run["sim_time_s"].get<double>(), 8.0,
                0.02);  // finished before its longest time
    const auto rows = linesOf(read("track.csv"));
    const auto rudderAt = [&](std::size_t second) {
        std::string row = rows.at(1 + second);
        for (int i = 0; i < 13; ++i) row = row.substr(row.find(',') + 1);
        return std::stod(row);
    };
    EXPECT_EQ(rudderAt(3), 0.0);
    EXPECT_GT(rudderAt(5), 1.0);
}

TEST_F(RunOptions, AScenarioMayBeAFile) {
    write("mine.json", sagara::test::lessonWith("/id", "\"my-lesson\""));
    const nlohmann::json run = simJson({"run", "--scenario", at("mine.json"), "--fast", "--duration-s", "2"});
    EXPECT_EQ(run["scenario"], "my-lesson");
    EXPECT_EQ(simDone({"list", "scenarios"}).out.find("my-lesson"),
              std::string::npos);  // not taken in
    EXPECT_NE(simDone({"list", "runs"}).out.find("my-lesson"), std::string::npos);
}

TEST_F(RunOptions, TraineeAndRunAreFiled) {
    simDone(lesson("3", {"--trainee", "A. Perera", "--type", "assess", "--level", "2"}));
    simDone(lesson("3", {"--trainee", "A. Perera"}));
    const auto runs = linesOf(simDone({"list", "runs"}).out);
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_NE(runs[1].find("basic-navigation     level 2  assess      finished"), std::string::npos)
        << runs[1];
    for (const std::string& run : runs) EXPECT_NE(run.find("A. Perera"), std::string::npos) << run;
    EXPECT_NE(runs[0].find("recordings/"), std::string::npos) << runs[0];
}

TEST_F(RunOptions, RunsThatStartTogetherDoNotShareARecording) {
    std::vector<std::unique_ptr<Program>> programs;
    for (int i = 0; i < 8; ++i)  // of one data folder that is not there yet
        programs.push_back(std::make_unique<Program>(withData(lesson("1")), m_folder));
    for (const auto& program : programs) {
        const Outcome run = program->wait();
        EXPECT_EQ(run.exitCode, 0);
        EXPECT_EQ(run.err, "");
    }
    EXPECT_EQ(namesIn(data() / "recordings").size(), programs.size());
    EXPECT_EQ(linesOf(simDone({"list", "runs"}).out).size(), programs.size());
}

TEST_F(RunOptions, ARecordingOfTheSameNameIsReplacedAndBothRunsStayFiled) {
    simDone(lesson("1", {"--record", at("run.sgr"), "--level", "1"}));
    const std::string second = hashIn(simDone(lesson("2", {"--record", at("run.sgr"), "--level", "4"})));
    EXPECT_EQ(hashIn(simDone({"replay", at("run.sgr")})), second);
    std::string all;
    for (const std::string& run : linesOf(simDone({"list", "runs"}).out)) {
        const bool replaced = run.ends_with("run.sgr (replaced, run 1)");
        EXPECT_NE(run.find(replaced ? "level 1" : "level 4"), std::string::npos) << run;
        EXPECT_NE(run.find(replaced ? "00:01" : "00:02"), std::string::npos) << run;
        all += replaced ? "old " : "new ";
    }
    EXPECT_EQ(all, "new old ");
}

TEST_F(RunOptions, ATraineeWhomTheRosterCannotTakeIsRefused) {
    const Outcome run = sim(lesson("1", {"--trainee", std::string(81, 'x')}));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_NE(run.err.find("the name is too long, expected 1 to 80 characters"), std::string::npos)
        << run.err;
    EXPECT_TRUE(namesIn(data() / "recordings").empty());
}

}  // namespace
}  // namespace sagara::run::test
