#include <csignal>

#include "SimTest.h"

namespace sagara::run::test {
namespace {

namespace fs = std::filesystem;

class Resume : public SimTest {
protected:
    /// Starts a run in real time and kills it when its recording has grown by some seconds.
    void killInMidRun(const Arguments& more) const {
        Arguments arguments{"run", "--scenario", "basic-navigation", "--record", at("run.sgr")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        Program run(withData(arguments), m_folder);
        EXPECT_TRUE(happens([this] { return secondsIn("run.sgr") >= 2; }));
        run.kill();
        EXPECT_EQ(run.wait().signal, SIGKILL);
    }
    /// Chunks "T" of a recording: kind, length in four bytes, sum in eight, payload.
    int secondsIn(const char* name) const {
        if (!fs::exists(at(name))) return 0;
        const std::string bytes = read(name);
        int seconds = 0;
        for (std::size_t i = 8; i + 13 <= bytes.size();) {
            if (bytes[i] == 'T') ++seconds;
            std::size_t length = 0;
            for (std::size_t k = 4; k > 0; --k)
                length = length << 8 | static_cast<unsigned char>(bytes[i + k]);
            i += 13 + length;
        }
        return seconds;
    }
};

TEST_F(Resume, AKilledRunGoesOnToTheSameEnd) {
    const nlohmann::json whole = simJson(lesson("25", {"--helm", "pilot", "--seed", "3", "--level", "4"}));
    killInMidRun({"--helm", "pilot", "--seed", "3", "--level", "4"});
    EXPECT_NE(simDone({"list", "runs"}).out.find("running"), std::string::npos);
    const Outcome resumed = simDone({"run", "--resume", at("run.sgr"), "--fast", "--duration-s", "25"});
    EXPECT_EQ(hashIn(resumed), whole["state_hash"]);
    EXPECT_NE(resumed.err.find("run.sgr: the end is missing: the run was broken off"), std::string::npos)
        << resumed.err;
    EXPECT_NE(resumed.err.find("taken up again at 00:0"), std::string::npos) << resumed.err;
    EXPECT_EQ(hashIn(simDone({"replay", at("run.sgr")})), whole["state_hash"]);
}

TEST_F(Resume, TheRunIsFiledOnceAndHasItsEndThen) {
    killInMidRun({"--trainee", "A. Perera"});
    simDone({"run", "--resume", at("run.sgr"), "--fast", "--duration-s", "5"});
    const std::string runs = simDone({"list", "runs"}).out;
    EXPECT_EQ(linesOf(runs).size(), 1u) << runs;
    EXPECT_EQ(runs.find("running"), std::string::npos) << runs;
    EXPECT_NE(runs.find("A. Perera"), std::string::npos) << runs;
}

TEST_F(Resume, PlannedCommandsAreNotLost) {
    write("orders.json", R"({"document": "commands", "version": 1, "scenario": "basic-navigation", "commands":
        [{"time_s": 0.5, "order": "helm", "rudder_deg": 20}, {"time_s": 8, "order": "telegraph",
          "step": "deadSlowAhead"}, {"time_s": 20, "order": "finish"}]})");
    const nlohmann::json whole = simJson(lesson("60", {"--commands", at("orders.json")}));
    killInMidRun({"--commands", at("orders.json")});
    EXPECT_EQ(hashIn(simDone({"run", "--resume", at("run.sgr"), "--fast"})), whole["state_hash"]);
}

TEST_F(Resume, ARunKilledTwiceStillComesToTheSameEnd) {
    const nlohmann::json whole = simJson(lesson("40", {"--helm", "pilot", "--record", at("whole.sgr")}));
    const std::string bytes = read("whole.sgr");
    // what a kill leaves: a recording cut anywhere
    write("run.sgr", bytes.substr(0, bytes.size() * 98 / 100));
    Outcome resumed = simDone({"run", "--resume", at("run.sgr"), "--fast", "--duration-s", "35"});
    EXPECT_NE(hashIn(resumed), whole["state_hash"]);
    const std::string second = read("run.sgr");
    write("run.sgr", second.substr(0, second.size() - 2000));
    resumed = simDone({"run", "--resume", at("run.sgr"), "--fast", "--duration-s", "40"});
    EXPECT_EQ(hashIn(resumed), whole["state_hash"]);
    EXPECT_EQ(hashIn(simDone({"replay", at("run.sgr")})), whole["state_hash"]);
}

TEST_F(Resume, TheEndAskedForIsInTheRecording) {
    const nlohmann::json whole = simJson(lesson("20"));
    killInMidRun({"--duration-s", "20"});
    const Outcome resumed = simDone({"run", "--resume", at("run.sgr"), "--fast"});
    EXPECT_EQ(hashIn(resumed), whole["state_hash"]);
}

TEST_F(Resume, SaysWhatItHasFromTheRecording) {
    killInMidRun({"--seed", "3"});
    const Outcome resumed = simDone({"run", "--scenario", "basic-navigation", "--seed", "9", "--resume",
                                     at("run.sgr"), "--fast", "--duration-s", "5"});
    EXPECT_NE(resumed.err.find("--seed is not used: --resume has it from the recording"), std::string::npos);
    EXPECT_EQ(hashIn(resumed), simJson(lesson("5", {"--seed", "3"}))["state_hash"]);
}

TEST_F(Resume, ARunThatIsBeingSailedIsLeftToItsProgram) {
    Program running(withData({"run", "--scenario", "basic-navigation", "--record", at("run.sgr")}), m_folder);
    ASSERT_TRUE(happens([this] { return secondsIn("run.sgr") >= 1; }));
    for (const Arguments& second :
         {Arguments{"run", "--resume", at("run.sgr"), "--fast"}, lesson("1", {"--record", at("run.sgr")})}) {
        const Outcome outcome = sim(second);
        EXPECT_EQ(outcome.exitCode, 1);
        EXPECT_NE(outcome.err.find("another program is writing this recording"), std::string::npos)
            << outcome.err;
    }
    running.kill();
    running.wait();
    EXPECT_GE(secondsIn("run.sgr"), 1);
}

TEST_F(Resume, ARunThatHasEndedIsLeftAsItIs) {
    simDone(lesson("3", {"--record", at("run.sgr")}));
    const std::string before = read("run.sgr");
    const Outcome resumed = sim({"run", "--resume", at("run.sgr"), "--fast"});
    EXPECT_EQ(resumed.exitCode, 2);
    EXPECT_EQ(resumed.err, at("run.sgr") + ": this run has ended; there is nothing to take up again\n");
    EXPECT_EQ(read("run.sgr"), before);
}

}  // namespace
}  // namespace sagara::run::test
