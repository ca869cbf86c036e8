#include <filesystem>

#include "../run/SimTest.h"

namespace sagara::run::test {
namespace {

class Identify : public SimTest {
protected:
    /// A run of the tool `manoeuvre` as a trial.
    void tryShip(const std::string& name, const std::string& header, Arguments arguments) const {
        arguments.insert(arguments.begin(), {"manoeuvre", "--vessel", "kvlcc2", "--speed-mps", "7.97"});
        std::filesystem::create_directories(at("trials"));
        write("trials/" + name, header + simDone(arguments).out);
    }
    Arguments identify(Arguments more) const {
        Arguments all{"identify", "--trials", at("trials"), "--out", at("fitted.json")};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};

TEST_F(Identify, RunsOfAShipGiveAFittedDocumentThatRuns) {
    tryShip("turn.csv", "# kind: turning\n",
            {"--test", "turning", "--rudder-deg", "35", "--duration-s", "400", "--dt-s", "10"});
    tryShip("zigzag.csv", "# kind: zigzag\n# approach_mps: 7.97\n",
            {"--test", "zigzag", "--rudder-deg", "20", "--duration-s", "300", "--dt-s", "10"});
    const Outcome done =
        simDone(identify({"--vessel", "kvlcc2", "--fit", "rudder", "--report", at("c.csv")}));
    for (const char* words : {"kvlcc2, model mmg", "turn.csv", "zigzag.csv", "rudder.kappa", "Nomoto: K 0.0",
                              "X_uu: ", "What the trials cannot determine"})
        EXPECT_NE(done.out.find(words), std::string::npos) << words << "\n" << done.out;
    EXPECT_EQ(done.out.find("hull.Yv"), std::string::npos);  // not asked for
    EXPECT_EQ(linesOf(read("c.csv")).front(), "name,before,after,deviation,prior,told");
    EXPECT_EQ(linesOf(read("c.csv")).size(), 9u);
    const nlohmann::json fitted = nlohmann::json::parse(read("fitted.json"));
    EXPECT_EQ(fitted["models"][0]["rudder"]["quality"], "fitted");
    EXPECT_EQ(fitted["models"][0]["hull"]["quality"], "published");
    // Her own runs leave her what she was.
    EXPECT_NEAR(fitted["models"][0]["rudder"]["kappa"].get<double>(), 0.5, 0.01);
    simDone({"manoeuvre", "--vessel", at("fitted.json"), "--test", "zigzag", "--duration-s", "100"});
}

TEST_F(Identify, AllProblemsOfAllFilesAreToldAtOnce) {
    std::filesystem::create_directories(at("trials"));
    write("trials/a.csv", "# kind: decay\ntime_s,roll_deg\n0,1\n1,wet\n");
    write("trials/b.csv", "time_s,heading_deg\n0,1\n");
    write("trials/notes.txt", "not a trial");
    const Outcome outcome = sim(identify({"--vessel", "kon-tiki"}));
    EXPECT_EQ(outcome.exitCode, 2);
    for (const char* words :
         {"there is no vessel \"kon-tiki\"", "a.csv: line 4, roll_deg is \"wet\", expected -90 to 90",
          "b.csv: does not say what it is"})
        EXPECT_NE(outcome.err.find(words), std::string::npos) << words << "\n" << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(at("fitted.json")));
}

TEST_F(Identify, WhatCannotBeDoneIsRefused) {
    const auto refused = [&](const Arguments& arguments, const std::string& words) {
        const Outcome outcome = sim(arguments);
        EXPECT_EQ(outcome.exitCode, 2) << outcome.err;
        EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    };
    refused(identify({"--vessel", "kvlcc2"}), "expected a folder of trials");
    std::filesystem::create_directories(at("trials"));
    refused(identify({"--vessel", "kvlcc2"}), "has no *.csv");
    write("trials/speed.csv", "# kind: speed\nshaft_rpm,speed_kn\n90,13\n");
    refused(identify({"--vessel", "kvlcc2", "--fit", "luck"}),
            "--fit: model mmg has no luck, expected astern, hull, rudder, wake");
    write("trials/deep.csv", "# kind: decay\n# depth_m: 20\ntime_s,roll_deg\n0,1\n1,2\n2,3\n3,4\n4,5\n");
    refused(identify({"--vessel", "kvlcc2"}),
            "deep.csv: depth_m is 20, expected more than her draught, 20.8 m");
    std::filesystem::remove(at("trials/deep.csv"));
    const Outcome nowhere = sim({"identify", "--vessel", "kvlcc2", "--trials", at("trials"), "--fit", "hull",
                                 "--out", at("no/such/folder.json")});
    EXPECT_EQ(nowhere.exitCode, 1) << nowhere.err;
}

}  // namespace
}  // namespace sagara::run::test
