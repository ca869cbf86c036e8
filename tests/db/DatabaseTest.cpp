#include "db/Database.h"

#include <gtest/gtest.h>

#include "Support.h"
#include "db/SettingRepository.h"
#include "db/schema/Schema.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace test;
using namespace Qt::StringLiterals;

std::int64_t pragma(Database& db, const QString& name) {
    Query row(db.connection(), u"PRAGMA "_s + name);
    return row.next() ? row.integer(name) : -1;
}

TEST(Database, FolderAndFileAreMadeWhenMissing) {
    const TemporaryFolder folder;
    const Database db(folder / "deep/er/sagara.db");
    EXPECT_TRUE(std::filesystem::is_regular_file(folder / "deep/er/sagara.db"));
    EXPECT_EQ(db.info().schemaVersion, kSchemaVersion);
}

TEST(Database, WhatWasStoredIsThereTheNextTime) {
    const TemporaryFolder folder;
    {
        Database db(folder / "sagara.db");
        SettingRepository(db).put("language", "si");
    }
    Database db(folder / "sagara.db");
    EXPECT_EQ(SettingRepository(db).find("language"), "si");
}

TEST(Database, ClosedItIsOneFileAndNothingElse) {
    const TemporaryFolder folder;
    { SettingRepository(*std::make_unique<Database>(folder / "sagara.db")).put("a", "b"); }
    const auto files = contentsOf(folder.path());
    ASSERT_EQ(files.size(), 1u);
    EXPECT_EQ(files.begin()->first, "sagara.db");
}

TEST(Database, ConnectionIsSetUpAsDocumented) {
    const TemporaryFolder folder;
    Database db(folder / "sagara.db", std::chrono::milliseconds(1234));
    Query mode(db.connection(), u"PRAGMA journal_mode"_s);
    ASSERT_TRUE(mode.next());
    EXPECT_EQ(mode.text(u"journal_mode"_s), "wal");
    EXPECT_EQ(pragma(db, u"foreign_keys"_s), 1);
    EXPECT_EQ(pragma(db, u"synchronous"_s), 1);  // NORMAL
    EXPECT_EQ(pragma(db, u"application_id"_s), kApplicationId);
    Query timeout(db.connection(), u"PRAGMA busy_timeout"_s);
    ASSERT_TRUE(timeout.next());
    EXPECT_EQ(timeout.integer(u"timeout"_s), 1234);
}

TEST(Database, SeveralObjectsInOneProcessSeeOneAnothersRows) {
    const TemporaryFolder folder;
    Database first(folder / "sagara.db");
    Database second(folder / "sagara.db");
    SettingRepository(first).put("who", "first");
    EXPECT_EQ(SettingRepository(second).find("who"), "first");
    SettingRepository(second).put("who", "second");
    EXPECT_EQ(SettingRepository(first).find("who"), "second");
}

TEST(Database, FileNamesWithSpecialCharactersAreTakenAsTheyAre) {
    const TemporaryFolder folder;
    for (const char* name :
         {"with space.db", "50%41?mode=ro#x&y.db", "නැව.db", "quote'\".db", "semi;colon=.db"}) {
        { Database db(folder / name); }
        EXPECT_TRUE(std::filesystem::is_regular_file(folder / name)) << name;
    }
    EXPECT_EQ(contentsOf(folder.path()).size(), 5u);
}

TEST(Database, InfoTellsFileSizeVersionAndCounts) {
    const TemporaryFolder folder;
    Database db(folder / "sagara.db");
    DocumentRepository(db, DocumentTable::Vessel).put(patrol(), kMorning);
    const DatabaseInfo info = db.info();
    EXPECT_EQ(info.file, folder / "sagara.db");
    EXPECT_GT(info.size_bytes, 0);
    std::map<std::string, std::int64_t> counts;
    for (const TableCount& c : info.counts) counts[c.table] = c.rows;
    const std::map<std::string, std::int64_t> expected{
        {"area", 0},    {"assessment", 0}, {"assignment", 0}, {"class", 0},    {"document_history", 0},
        {"grade", 0},   {"person", 0},     {"run", 0},        {"scenario", 0}, {"seakeeping", 0},
        {"setting", 0}, {"vessel", 1}};
    EXPECT_EQ(counts, expected);
}

TEST(Database, IntegrityOfAHealthyDatabaseFindsNothing) {
    const TemporaryFolder folder;
    Database db(folder / "sagara.db");
    DocumentRepository(db, DocumentTable::Vessel).put(patrol(), kMorning);
    fileRun(db, {lesson(), ended(), good()});
    EXPECT_TRUE(db.integrity().empty());
}

TEST(Database, IntegrityNamesDanglingReferencesAndChangedDocuments) {
    const TemporaryFolder folder;
    Database db(folder / "sagara.db");
    DocumentRepository(db, DocumentTable::Vessel).put(patrol(), kMorning);
    fileRun(db, {lesson(), ended(), good()});
    execute(db.connection(), u"UPDATE vessel SET document = '{}'"_s);
    execute(db.connection(), u"PRAGMA foreign_keys = OFF"_s);
    execute(db.connection(), u"UPDATE run SET person_id = 77"_s);
    const std::vector<std::string> expected{"run 1: refers to a missing row of person",
                                            "vessel patrol51: the document is not the one stored"};
    EXPECT_EQ(db.integrity(), expected);
}

TEST(DatabaseDeathTest, AnotherThreadMayNotUseIt) {
    GTEST_FLAG_SET(death_test_style, "fast");  // the child shares our folder, so it is removed
    const TemporaryFolder folder;
    EXPECT_DEATH(
        {
            Database db(folder / "sagara.db");
            std::thread([&db] { (void)db.info(); }).join();
        },
        "used by the thread that made it");
}

}  // namespace
}  // namespace sagara::db
