#include "SimTest.h"
#include "tests/support/Assets.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::run::test {
namespace {

namespace fs = std::filesystem;
using sagara::test::lessonWith;
using sagara::test::with;

class ValidateDocument : public SimTest {
protected:
    /// What is wrong with a text, a line each; every line begins with the file's name, which is left out.
    std::vector<std::string> problemsOf(const std::string& text) const {
        write("doc.json", text);
        const Outcome outcome = sim({"validate-document", at("doc.json")});
        EXPECT_EQ(outcome.exitCode, 2) << outcome.out;
        EXPECT_EQ(outcome.out, "");
        std::vector<std::string> problems;
        for (const std::string& line : linesOf(outcome.err)) {
            EXPECT_EQ(line.rfind(at("doc.json") + ": ", 0), 0u) << line;
            problems.push_back(line.substr(std::min(line.size(), at("doc.json").size() + 2)));
        }
        return problems;
    }
    static void expectOneBegins(const std::vector<std::string>& problems, const std::string& begin) {
        std::string all;
        for (const std::string& p : problems) {
            if (p.rfind(begin, 0) == 0) return;
            all += p + "\n";
        }
        ADD_FAILURE() << "none begins with: " << begin << "\n" << all;
    }
};

TEST_F(ValidateDocument, EveryShippedOneHasNoProblems) {
    int documents = 0;
    for (const auto& entry : fs::recursive_directory_iterator(SAGARA_ASSETS)) {
        // beside an area.json lies what it was imported from
        const bool ofAnArea = entry.path().string().find("/areas/") != std::string::npos;
        const bool ofThemes = entry.path().string().find("/themes/") != std::string::npos;  // colours
        // cases of `sagara-sim validate`, which reads them
        const bool ofValidation = entry.path().string().find("/validation/") != std::string::npos;
        if (entry.path().extension() != ".json" || ofThemes || ofValidation ||
            (ofAnArea && entry.path().filename() != "area.json"))
            continue;
        ++documents;
        const std::string file = entry.path().string();
        EXPECT_EQ(simDone({"validate-document", file}).out, file + ": no problems\n");
    }
    EXPECT_GE(documents, 5);
}

TEST_F(ValidateDocument, AllProblemsOfAScenarioAreToldWithTheirPath) {
    std::string text = lessonWith("/weather/wind/speed_kn", "\"strong\"");
    text = with(text, "/longest_min", "[75]");
    text = with(text, "/mission/passscore", "70");
    text = with(text, "/route/waypoints/2/radius_M", "-1");
    const auto problems = problemsOf(text);
    expectOneBegins(problems, "weather.wind.speed_kn is \"strong\", expected 0 to 120 kn");
    expectOneBegins(problems, "longest_min is ");
    expectOneBegins(problems, "mission.passscore is unknown, expected one of ");
    expectOneBegins(problems, "route.waypoints[2].radius_M is -1, expected ");
    EXPECT_EQ(problems.size(), 4u);
}

TEST_F(ValidateDocument, AMissingVesselIsNamed) {
    EXPECT_EQ(
        problemsOf(lessonWith("/ownShips/0/vessel", "\"titanic\"")),
        (std::vector<std::string>{"ownShips[0].vessel names \"titanic\", which is not known, expected the "
                                  "id of vessel in the database"}));
}

TEST_F(ValidateDocument, AMissingPictureIsNamed) {
    EXPECT_EQ(problemsOf(lessonWith("/traffic/3/picture", "\"dhow\"")),
              (std::vector<std::string>{"traffic[3].picture names \"dhow\", which is not known, expected the "
                                        "id of picture in assets/pictures"}));
    const std::string picture = sagara::test::readAsset("pictures/ferry.json");
    EXPECT_EQ(problemsOf(with(picture, "/model", "\"dhow.ac\"")),
              (std::vector<std::string>{
                  "model names \"dhow.ac\", which is not there, expected a file in assets/models"}));
    expectOneBegins(problemsOf(with(picture, "/up", "\"y\"")), "up is \"y\", expected one of +x, ");
}

TEST_F(ValidateDocument, NotANumberIsNoJsonAndItsLineIsTold) {
    std::string text = "{\"document\": \"scenario\",\n \"version\": NaN}";
    const auto problems = problemsOf(text);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].rfind("is not JSON (parse error at line 2", 0), 0u) << problems[0];
}

TEST_F(ValidateDocument, AStartAgroundOrInAnotherShipIsRefused) {
    std::string text = lessonWith("/ownShips/0/berth", "");
    text = with(text, "/ownShips/0/lines", "");
    text = with(text, "/mission/tasks/0", "");
    text = with(text, "/pilot", "[]");
    text = with(text, "/ownShips/0/heading_deg", "0");
    expectOneBegins(problemsOf(with(text, "/ownShips/0/at", R"({"lat": 6.0262, "lon": 80.2202})")),
                    "ownShips[0] starts aground, under-keel clearance -");
    expectOneBegins(problemsOf(with(text, "/ownShips/0/at", R"({"lat": 6.0290, "lon": 80.2180})")),
                    "ownShips[0] starts on land, expected a place with all of her afloat");
    EXPECT_EQ(problemsOf(lessonWith("/traffic/-", R"({"id": "inside", "name": "Inside", "type": "fishing",
                  "behaviour": "lying", "length_m": 10, "beam_m": 3, "draught_m": 1,
                  "route": [{"at": {"lat": 6.03188, "lon": 80.23042}}]})")),
              (std::vector<std::string>{"traffic[12] starts in ownShips[0], expected ships apart"}));
}

TEST_F(ValidateDocument, AVesselAnAreaAndARubricAreChecked) {
    const std::string vessel = sagara::test::readAsset("vessels/patrol51.json");
    expectOneBegins(problemsOf(with(vessel, "/hull/beam_m", "-3")), "hull.beam_m is -3, expected 1 to 80 m");
    const std::string area = sagara::test::readAsset("areas/galle/area.json");
    expectOneBegins(problemsOf(with(area, "/ialaRegion", "\"C\"")),
                    "ialaRegion is \"C\", expected one of A, B");
    const std::string rubric = R"({"document": "rubric", "version": 1, "scenario": ")";
    expectOneBegins(problemsOf(rubric + "basic-navigation\"}"), "mission is missing");
    expectOneBegins(problemsOf(rubric + "nowhere\"}"), "scenario is \"nowhere\", expected a scenario in the");
}

TEST_F(ValidateDocument, AVesselIsTakenOnATrialTrip) {
    const std::string ferry = sagara::test::readAsset("vessels/ferry86.json");
    EXPECT_EQ(
        problemsOf(with(ferry, "/hull/metacentricHeight_m", "17.4")),
        (std::vector<std::string>{"hull.metacentricHeight_m is 17.4, expected 0.05 to 8.62 m, or the centre "
                                  "of gravity is below the keel"}));
    EXPECT_EQ(
        problemsOf(with(ferry, "/propulsion/units/1/engine/power_kW", "900")),
        (std::vector<std::string>{"propulsion.units[1].engine gives 32.1 kN m, enough for 181 rpm and 15 "
                                  "kn, expected torque for full ahead, 267 rpm"}));
}

TEST_F(ValidateDocument, CommandsAreCheckedAgainstTheirScenario) {
    const std::string text = sagara::test::readAsset("commands/basic-navigation-bad-run.json");
    expectOneBegins(problemsOf(with(text, "/commands/3/order", "\"dance\"")),
                    "commands[3].order is \"dance\", expected one of helm, ");
    expectOneBegins(problemsOf(with(text, "/scenario", "\"nowhere\"")), "scenario is \"nowhere\"");
    expectOneBegins(problemsOf(with(text, "/scenario", "")), "scenario is missing");
}

TEST_F(ValidateDocument, AnUnknownKindSaysWhatThereIs) {
    EXPECT_EQ(problemsOf(R"({"document": "poem"})"),
              (std::vector<std::string>{
                  "document is \"poem\", expected one of vessel, area, scenario, commands, rubric, wall, "
                  "picture, waves"}));
    expectOneBegins(problemsOf("{}"), "document is missing");
    expectOneBegins(problemsOf("[]"), "");
    expectOneBegins(problemsOf(""), "is not JSON");
}

TEST_F(ValidateDocument, AFileThatIsNotThereIsNamed) {
    const Outcome outcome = sim({"validate-document", at("none.json")});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_EQ(outcome.err, at("none.json") + ": cannot be read (No such file or directory)\n");
}

}  // namespace
}  // namespace sagara::run::test
