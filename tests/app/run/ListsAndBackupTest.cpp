#include <algorithm>

#include "SimTest.h"
#include "Sqlite.h"
#include "tests/support/ShippedVessels.h"

namespace sagara::run::test {
namespace {

namespace fs = std::filesystem;

class ListsAndBackup : public SimTest {};

/// First word of each line.
std::vector<std::string> firstWords(const std::string& text) {
    std::vector<std::string> words;
    for (const std::string& line : linesOf(text)) words.push_back(line.substr(0, line.find(' ')));
    return words;
}

TEST_F(ListsAndBackup, WhatIsShippedIsThereAtTheFirstStart) {
    EXPECT_EQ(firstWords(simDone({"list", "areas"}).out), (std::vector<std::string>{"galle"}));
    EXPECT_EQ(firstWords(simDone({"list", "scenarios"}).out),
              (std::vector<std::string>{"basic-navigation", "heavy-weather"}));
    const std::string vessels = simDone({"list", "vessels"}).out;
    const std::vector<std::string> ids = firstWords(vessels);
    for (const std::string& id : sagara::test::shippedVessels())
        EXPECT_NE(std::find(ids.begin(), ids.end(), id), ids.end()) << id;
    EXPECT_NE(vessels.find("51.5 m patrol vessel"), std::string::npos);
    EXPECT_NE(vessels.find("shipped"), std::string::npos);
    EXPECT_EQ(simDone({"list", "runs"}).out, "");
}

TEST_F(ListsAndBackup, RunsAreListedNewestFirstWithTheirGrade) {
    simDone(lesson("1", {"--level", "1"}));
    simDone(lesson("2", {"--level", "5"}));
    const auto runs = linesOf(simDone({"list", "runs"}).out);
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_NE(runs[0].find("level 5"), std::string::npos);
    EXPECT_NE(runs[1].find("level 1"), std::string::npos);
    EXPECT_NE(runs[0].find("100 not passed"), std::string::npos) << runs[0];
}

TEST_F(ListsAndBackup, TheBackupOpensAndListsTheSame) {
    simDone(lesson("1", {"--trainee", "A. Perera"}));
    const std::string before = simDone({"list", "runs"}).out;
    const Outcome backup = simDone({"backup", at("copy.db")});
    EXPECT_EQ(backup.out, "The database was copied to " + at("copy.db") + ".\n");
    fs::create_directories(at("restored"));
    fs::copy_file(at("copy.db"), at("restored/sagara.db"));
    const Outcome restored = Program({"list", "runs", "--data", at("restored")}, m_folder).wait();
    EXPECT_EQ(restored.out, before);
    EXPECT_EQ(Sqlite(at("copy.db")).value("PRAGMA integrity_check"), "ok");
}

TEST_F(ListsAndBackup, TheBackupIsMadeWhileARunIsSailed) {
    Program run(withData({"run", "--scenario", "basic-navigation", "--duration-s", "2"}), m_folder);
    const fs::path recordings = data() / "recordings";
    ASSERT_TRUE(happens([&] { return fs::exists(recordings) && !fs::is_empty(recordings); }));
    simDone({"backup", at("copy.db")});
    EXPECT_EQ(run.wait().exitCode, 0);
    EXPECT_EQ(Sqlite(at("copy.db")).value("PRAGMA integrity_check"), "ok");
}

TEST_F(ListsAndBackup, ABackupOverwritesNothing) {
    write("copy.db", "precious");
    const Outcome backup = sim({"backup", at("copy.db")});
    EXPECT_EQ(backup.exitCode, 1);
    EXPECT_EQ(backup.err, at("copy.db") +
                              ": no backup was made: the file exists and it was not asked to overwrite it. "
                              "Choose another name.\n");
    EXPECT_EQ(read("copy.db"), "precious");
    EXPECT_EQ(sim({"backup", database().string()}).exitCode, 1);
    EXPECT_EQ(simDone({"list", "areas"}).err, "");
}

TEST_F(ListsAndBackup, ABackupIntoNoFolderSaysSo) {
    const Outcome backup = sim({"backup", at("nowhere/copy.db")});
    EXPECT_EQ(backup.exitCode, 1);
    EXPECT_EQ(backup.err, at("nowhere/copy.db") +
                              ": no backup was made: there is no such folder. Choose another name.\n");
}

}  // namespace
}  // namespace sagara::run::test
