#include <set>

#include "SimTest.h"

namespace sagara::run::test {
namespace {

namespace fs = std::filesystem;

class BadCommandLine : public SimTest {
protected:
    /// Refused with exit code 2, a message that holds these words, nothing on standard output, no file made.
    void expectRefused(const Arguments& arguments, const std::string& words) const {
        const std::set<fs::path> before = files();
        const Outcome outcome = sim(arguments);
        std::string line;
        for (const std::string& a : arguments) line += a + " ";
        EXPECT_EQ(outcome.exitCode, 2) << line << outcome.err;
        EXPECT_EQ(outcome.signal, 0) << line;
        EXPECT_EQ(outcome.out, "") << line;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << line << "\n" << outcome.err;
        EXPECT_EQ(files(), before) << line;
    }
    /// All files but the database, which any command may make.
    std::set<fs::path> files() const {
        std::set<fs::path> files;
        for (const auto& entry : fs::recursive_directory_iterator(m_folder)) {
            if (entry.is_regular_file() && entry.path().filename().string().rfind("sagara.db", 0) != 0)
                files.insert(entry.path());
        }
        return files;
    }
    std::string commands(const std::string& list) const {
        write("orders.json", R"({"document": "commands", "version": 1, "scenario": "basic-navigation",
            "commands": [)" + list +
                                 "]}");
        return at("orders.json");
    }
};

TEST_F(BadCommandLine, UnknownWordsAreRefused) {
    expectRefused(lesson("1", {"--speed"}), "--speed");
    expectRefused({"walk"}, "A subcommand is required");
    expectRefused({"list", "ships"}, "ships");
    expectRefused(lesson("1", {"--helm", "captain"}), "captain");
    expectRefused(lesson("1", {"--type", "holiday"}), "holiday");
}

TEST_F(BadCommandLine, NothingAtAllIsRefused) {
    const Outcome outcome = Program({}, m_folder).wait();
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_NE(outcome.err.find("subcommand"), std::string::npos) << outcome.err;
}

TEST_F(BadCommandLine, HelpIsNoFault) {
    EXPECT_NE(simDone({"run", "--help"}).out.find("--scenario"), std::string::npos);
}

TEST_F(BadCommandLine, AScenarioIsNeededAndMustBeKnown) {
    expectRefused({"run", "--fast"}, "--scenario or --resume is required");
    expectRefused({"run", "--scenario", "around-the-world"},
                  "there is no scenario \"around-the-world\" and no file of that name; see "
                  "`sagara-sim list scenarios`");
    expectRefused({"run", "--scenario", at("none.json")}, "there is no scenario \"" + at("none.json") + "\"");
    expectRefused({"run", "--scenario", m_folder.string()}, "is a folder, expected a file");
    expectRefused({"run", "--scenario", ""}, "there is no scenario \"\"");
}

TEST_F(BadCommandLine, NumbersOutOfRangeAreRefused) {
    for (const char* level : {"0", "6", "-1", "2.5", "three", ""})
        expectRefused(lesson("1", {"--level", level}), "--level");
    for (const char* seconds : {"-1", "-0.001", "1e9", "nan", "inf", "soon"})
        expectRefused(lesson(seconds), "--duration-s");
    for (const char* seed : {"-1", "1.5", "18446744073709551616", "x"})
        expectRefused(lesson("1", {"--seed", seed}), "--seed");
    for (const char* rate : {"0", "-1", "51", "nan"})
        expectRefused(lesson("1", {"--track", at("t.csv"), "--track-hz", rate}), "--track-hz");
}

TEST_F(BadCommandLine, OptionsOfReplayAreChecked) {
    simDone(lesson("2", {"--record", at("run.sgr")}));
    expectRefused({"replay"}, "recording is required");
    for (const char* second : {"-1", "nan", "later"})
        expectRefused({"replay", at("run.sgr"), "--until-s", second}, "--until-s");
    expectRefused({"replay", at("run.sgr"), "--rubric", at("none.json")}, "none.json: cannot be read");
    expectRefused({"replay", at("run.sgr"), "--track-hz", "nan"}, "--track-hz");
}

TEST_F(BadCommandLine, ReplayNeedsARecording) {
    expectRefused({"replay", at("none.sgr")}, "none.sgr: cannot be read (No such file or directory)");
    expectRefused({"replay", m_folder.string()}, "is a folder, expected a file");
    write("letter.sgr", "Dear diary, today we sailed.");
    expectRefused({"replay", at("letter.sgr")},
                  "letter.sgr: is not a Sagara recording of format 1: it does not begin with SGRREC01");
    expectRefused({"run", "--resume", at("letter.sgr")}, "letter.sgr: is not a Sagara recording of format 1");
    expectRefused({"run", "--resume", at("none.sgr")}, "none.sgr: cannot be read");
}

TEST_F(BadCommandLine, CommandFilesAreCheckedBeforeTheStart) {
    expectRefused(lesson("1", {"--commands", commands(R"({"time_s": 1, "order": "sing"})")}),
                  "orders.json: commands[0].order is \"sing\", expected one of helm, telegraph, ");
    expectRefused(lesson("1", {"--commands", commands(R"({"time_s": NaN, "order": "finish"})")}),
                  "orders.json: is not JSON (parse error at line 2");
    expectRefused(lesson("1", {"--commands", commands(R"({"time_s": -1, "order": "finish"})")}),
                  "commands[0].time_s is -1, expected 0 to 604800 s");
    expectRefused(lesson("1", {"--commands", commands(R"({"time_s": 1, "order": "helm", "ship": "kon-tiki",
                                                "rudder_deg": 5})")}),
                  "commands[0].ship is \"kon-tiki\", expected one of own");
    expectRefused(lesson("1", {"--commands", commands(R"({"time_s": 2, "order": "finish"},
                                                         {"time_s": 1, "order": "helm", "rudder_deg": 90})")}),
                  "commands[1].time_s is 1, expected not before the command above, 2 s");
    expectRefused(
        lesson("1", {"--commands", commands(R"({"time_s": 1, "order": "helm", "rudder_deg": 90})")}),
        "commands[0].rudder_deg is 90, expected -70 to 70 deg");
    expectRefused(lesson("1", {"--commands", at("none.json")}), "none.json: cannot be read");
}

TEST_F(BadCommandLine, AllProblemsOfACommandFileAreToldAtOnce) {
    const Outcome run = sim(lesson("1", {"--commands", commands(R"({"time_s": "early", "order": "helm"},
        {"time_s": 1, "order": "line", "line": "breast", "action": "hold", "colour": "red"})")}));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_EQ(linesOf(run.err).size(), 4u) << run.err;
}

TEST_F(BadCommandLine, DataMustBeAFolder) {
    write("file", "");
    for (const Arguments& arguments : {Arguments{"list", "runs"}, Arguments{"run", "--scenario", "x"}}) {
        Arguments all = arguments;
        all.insert(all.end(), {"--data", at("file")});
        const Outcome outcome = Program(all, m_folder).wait();
        EXPECT_EQ(outcome.exitCode, 2);
        EXPECT_EQ(outcome.err, at("file") + " is a file, expected a folder for Sagara's data\n");
    }
}

TEST_F(BadCommandLine, AFolderThatIsNotThereIsNamedBeforeTheRun) {
    const Outcome run = sim(lesson("1", {"--record", at("nowhere/run.sgr"), "--track", at("nowhere/t.csv"),
                                         "--report", at("nowhere/r.pdf")}));
    EXPECT_EQ(run.exitCode, 2);
    EXPECT_EQ(run.out, "");
    for (const char* file : {"run.sgr", "t.csv", "r.pdf"}) {
        const std::string message =
            at("nowhere/") + file + " cannot be written: there is no folder " + at("nowhere") + "\n";
        EXPECT_NE(run.err.find(message), std::string::npos) << run.err;
    }
    EXPECT_FALSE(fs::exists(at("nowhere")));
    EXPECT_EQ(simDone({"list", "runs"}).out, "");
}

}  // namespace
}  // namespace sagara::run::test
