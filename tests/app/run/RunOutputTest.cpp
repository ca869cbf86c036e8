#include <filesystem>

#include "SimTest.h"

namespace sagara::run::test {
namespace {

class RunOutput : public SimTest {};

std::vector<std::string> keysOf(const nlohmann::json& object) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items()) keys.push_back(key);
    return keys;  // sorted: nlohmann::json keeps them so
}

TEST_F(RunOutput, JsonIsOneObjectWithTheKeysOfTheWorkOrder) {
    const nlohmann::json run = simJson(lesson("20", {"--helm", "pilot"}));
    for (const char* key :
         {"scenario", "passed", "score", "tasks", "deductions", "sim_time_s", "wall_time_s", "state_hash"}) {
        EXPECT_TRUE(run.contains(key)) << key;
    }
    EXPECT_EQ(run["scenario"], "basic-navigation");
    EXPECT_EQ(run["passed"], false);
    EXPECT_EQ(run["score"], 100.0);
    EXPECT_NEAR(run["sim_time_s"].get<double>(), 20.0, 0.02);  // ends with the tick that is due then
    EXPECT_GT(run["wall_time_s"].get<double>(), 0.0);
    EXPECT_EQ(run["state_hash"].get<std::string>().size(), 16u);
    ASSERT_EQ(run["tasks"].size(), 5u);
    EXPECT_EQ(keysOf(run["tasks"][0]), (std::vector<std::string>{"done", "id", "time_s"}));
    EXPECT_EQ(run["tasks"][0]["id"], "spring-off");
    EXPECT_EQ(run["tasks"][0]["done"], false);
    EXPECT_TRUE(run["tasks"][0]["time_s"].is_null());
    EXPECT_EQ(run["deductions"], nlohmann::json::array());
}

TEST_F(RunOutput, NumbersHaveNoMoreDigitsThanMeanSomething) {
    const Outcome run = simDone(
        lesson("300", {"--json", "--commands", SAGARA_ASSETS "/commands/basic-navigation-bad-run.json"}));
    std::size_t digits = 0;  // behind a point
    for (const char c : run.out) {
        digits = c == '.' ? 1 : digits > 0 && c >= '0' && c <= '9' ? digits + 1 : 0;
        EXPECT_LE(digits, 7u) << run.out;
    }
}

TEST_F(RunOutput, TasksDoneCarryTheirTime) {
    const nlohmann::json run = simJson(lesson("150", {"--helm", "pilot"}));
    EXPECT_EQ(run["tasks"][0]["done"], true);
    EXPECT_GT(run["tasks"][0]["time_s"].get<double>(), 10.0);
    EXPECT_LT(run["tasks"][0]["time_s"].get<double>(), 150.0);
}

TEST_F(RunOutput, DeductionsCarryTimePlaceValueAndLimit) {
    // too fast through the entrance
    const nlohmann::json run =
        simJson(lesson("300", {"--commands", SAGARA_ASSETS "/commands/basic-navigation-bad-run.json"}));
    ASSERT_FALSE(run["deductions"].empty());
    const nlohmann::json& first = run["deductions"][0];
    for (const char* key :
         {"id", "title", "time_s", "lat_deg", "lon_deg", "value", "limit", "unit", "points"})
        EXPECT_TRUE(first.contains(key)) << key;
    EXPECT_EQ(first["id"], "speed");
    EXPECT_GT(first["value"], first["limit"]);
    EXPECT_NEAR(first["lat_deg"].get<double>(), 6.033, 0.005);
    EXPECT_NEAR(first["lon_deg"].get<double>(), 80.229, 0.005);
    EXPECT_LT(run["score"].get<double>(), 100.0);
}

TEST_F(RunOutput, WithoutJsonTheLastLineIsTheHash) {
    const Outcome run = simDone(lesson("5"));
    EXPECT_EQ(run.out.rfind("basic-navigation: not passed, ", 0), 0u) << run.out;
    EXPECT_NE(run.out.find("automatic score, advisory"), std::string::npos);
    EXPECT_EQ(hashIn(run).size(), 16u);
    EXPECT_EQ(hashIn(run).find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST_F(RunOutput, AShortRunSaysNothingOnStandardError) { EXPECT_EQ(simDone(lesson("1")).err, ""); }

TEST_F(RunOutput, ALongRunShowsProgress) {
    const Outcome run = simDone(
        {"run", "--scenario", "basic-navigation", "--duration-s", "3"});  // in real time, a line every 2 s
    EXPECT_NE(run.err.find("Single up and spring off  score 100"), std::string::npos) << run.err;
}

TEST_F(RunOutput, TheReportIsAPdf) {
    simDone(lesson("20", {"--helm", "pilot", "--report", at("report.pdf")}));
    const std::string pdf = read("report.pdf");
    EXPECT_EQ(pdf.rfind("%PDF-", 0), 0u);
    EXPECT_NE(pdf.find("%%EOF"), std::string::npos);
}

TEST_F(RunOutput, TheRecordingIsWhereItWasAskedForElseInTheDataFolder) {
    simDone(lesson("1"));
    const auto kept = namesIn(data() / "recordings");
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_NE(kept[0].find("-basic-navigation-1.sgr"), std::string::npos) << kept[0];
    simDone(lesson("1", {"--record", at("mine.sgr")}));
    EXPECT_EQ(namesIn(data() / "recordings"), kept);
    EXPECT_EQ(read("mine.sgr").rfind("SGRREC01", 0), 0u);
}

}  // namespace
}  // namespace sagara::run::test
