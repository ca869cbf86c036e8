#include <gtest/gtest.h>

#include "Support.h"
#include "db/SettingRepository.h"
#include "db/Transaction.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace test;
using namespace Qt::StringLiterals;
using namespace std::chrono_literals;
using Kind = DbError::Kind;
namespace fs = std::filesystem;

class LockedDatabase : public ::testing::Test {
protected:
    TemporaryFolder m_folder;
    Database m_db{m_folder / "sagara.db", 50ms};
    Database m_other{m_folder / "sagara.db", 50ms};
    void lock() { execute(m_other.connection(), u"BEGIN EXCLUSIVE"_s); }
    void release() { execute(m_other.connection(), u"ROLLBACK"_s); }
};

TEST_F(LockedDatabase, SaysSoAndWorksOnceReleased) {
    lock();
    const DbError error = errorOf([this] { fileRun(m_db, {lesson(), ended(), good()}); });
    EXPECT_EQ(error.kind(), Kind::Locked);
    EXPECT_EQ(std::string(error.what()), (m_folder / "sagara.db").string() +
                                             ": another program kept the database locked for 0.05 s "
                                             "(database is locked, SQLite 5). Close the other "
                                             "program, or wait until it is done, and try again.");
    release();
    fileRun(m_db, {lesson(), ended(), good()});
    EXPECT_EQ(RunRepository(m_db).count(), 1);
}

TEST_F(LockedDatabase, MayStillBeOpenedAndRead) {
    SettingRepository(m_db).put("a", "1");
    lock();
    Database third(m_folder / "sagara.db", 50ms);
    EXPECT_EQ(SettingRepository(third).find("a"), "1");
    EXPECT_EQ(SettingRepository(m_db).find("a"), "1");
}

TEST_F(LockedDatabase, PuttingWhatIsThereAlreadyNeedsNoLock) {
    DocumentRepository(m_db, DocumentTable::Vessel).put(patrol(), kMorning);
    lock();
    EXPECT_FALSE(DocumentRepository(m_db, DocumentTable::Vessel).put(patrol(), kMorning));
}

TEST(DatabaseKeptByOneProgram, CannotBeOpenedAndSaysSo) {
    const TemporaryFolder folder;
    { Database make(folder / "sagara.db"); }
    {
        Connection owner(folder / "sagara.db", Connection::Access::ReadWrite, kBusyTimeout);
        execute(owner, u"PRAGMA locking_mode = EXCLUSIVE"_s);
        execute(owner, u"INSERT INTO setting VALUES ('a', '1')"_s);
        EXPECT_EQ(errorOf([&] { Database db(folder / "sagara.db", 50ms); }).kind(), Kind::Locked);
    }
    Database db(folder / "sagara.db", 50ms);
    EXPECT_EQ(SettingRepository(db).find("a"), "1");
}

TEST(FullDisk, StoresNothingByHalvesAndStaysReadable) {
    const TemporaryFolder folder;
    Database db(folder / "sagara.db");
    DocumentRepository vessels(db, DocumentTable::Vessel);
    vessels.put(patrol(), kMorning);
    const std::int64_t pages = db.info().size_bytes / 4096;
    execute(db.connection(),
            u"PRAGMA max_page_count = %1"_s.arg(pages + 2));  // SQLite's own stand-in for a full disk
    const DbError error = errorOf([&] { vessels.put(patrol(std::string(100'000, 'x')), kNoon); });
    EXPECT_EQ(error.kind(), Kind::Full);
    EXPECT_NE(std::string(error.what()).find("the disk is full, nothing was stored"), std::string::npos)
        << error.what();
    EXPECT_EQ(vessels.find("patrol51")->text, patrol().text);
    EXPECT_EQ(vessels.entry("patrol51")->changed, kMorning);
    EXPECT_TRUE(db.integrity().empty());
    EXPECT_EQ(db.connection().openTransactions(), 0);
    execute(db.connection(), u"PRAGMA max_page_count = %1"_s.arg(pages + 1000));
    EXPECT_TRUE(vessels.put(patrol(std::string(100'000, 'x')), kNoon));
}

TEST(FullDisk, UndoesTheOuterTransactionToo) {
    const TemporaryFolder folder;
    Database db(folder / "sagara.db");
    const std::int64_t pages = db.info().size_bytes / 4096;
    execute(db.connection(), u"PRAGMA max_page_count = %1"_s.arg(pages + 2));
    const auto fillUp = [&db] {
        Transaction all(db);
        SettingRepository(db).put("a", "1");
        DocumentRepository(db, DocumentTable::Vessel).put(patrol(std::string(100'000, 'x')), kNoon);
        all.commit();
    };
    EXPECT_EQ(errorOf(fillUp).kind(), Kind::Full);
    EXPECT_FALSE(SettingRepository(db).find("a"));
    EXPECT_TRUE(db.integrity().empty());
}

class ReadOnly : public ::testing::Test {
protected:
    ReadOnly() {
        { Database make(m_file); }
        fs::permissions(m_file, fs::perms(0666));
    }
    void expectReadOnly(const fs::path& named) {
        const std::string error = errorAsOrdinaryUser([this] { Database db(m_file); });
        EXPECT_EQ(error,
                  kindPrefix(Kind::ReadOnly) + named.string() +
                      ": may not be written. Give this user the right to write the file and its folder, or "
                      "choose another one.");
    }
    TemporaryFolder m_folder;
    fs::path m_file = m_folder / "sagara.db";
};

TEST_F(ReadOnly, WritableFileOpensForAnOrdinaryUser) {
    EXPECT_EQ(errorAsOrdinaryUser([this] { Database db(m_file); }), "none");
}

TEST_F(ReadOnly, FileIsNamed) {
    fs::permissions(m_file, fs::perms(0444));
    const std::string before = readBytes(m_file);
    expectReadOnly(m_file);
    EXPECT_EQ(readBytes(m_file), before);
}

TEST_F(ReadOnly, FolderIsNamed) {
    fs::permissions(m_folder.path(), fs::perms(0555));
    expectReadOnly(m_folder.path());
}

TEST_F(ReadOnly, FolderTakesNoNewDatabase) {
    fs::remove(m_file);
    fs::permissions(m_folder.path(), fs::perms(0555));
    expectReadOnly(m_folder.path());
    EXPECT_TRUE(fs::is_empty(m_folder.path()));
}

TEST_F(ReadOnly, FolderThatMayNotBeEnteredIsNamed) {
    fs::permissions(m_folder.path(), fs::perms(0));
    expectReadOnly(m_file);
}

TEST_F(ReadOnly, WriteThroughAConnectionWithoutTheRightIsMapped) {
    Connection reader(m_file, Connection::Access::ReadOnly, kBusyTimeout);
    EXPECT_EQ(errorOf([&] { execute(reader, u"INSERT INTO setting VALUES ('a', '1')"_s); }).kind(),
              Kind::ReadOnly);
}

}  // namespace
}  // namespace sagara::db
