#include <gtest/gtest.h>

#include "Support.h"
#include "db/SettingRepository.h"
#include "db/schema/Schema.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace test;
using namespace Qt::StringLiterals;
using Kind = DbError::Kind;

class RefusedFile : public ::testing::Test {
protected:
    /// A closed database with a few rows, and a document of several pages.
    void makeHealthy() {
        Database db(m_file);
        DocumentRepository(db, DocumentTable::Vessel).put(patrol(std::string(40'000, 'p')), kMorning);
        for (int i = 0; i < 60; ++i) fileRun(db, {lesson(std::to_string(i)), ended(), good()});
    }
    DbError refusal() {
        const auto before = contentsOf(m_folder.path());
        DbError error = errorOf([this] { Database db(m_file); });
        EXPECT_EQ(contentsOf(m_folder.path()), before) << "nothing may change, nothing may be left beside it";
        return error;
    }
    void expectRefusal(Kind kind, const std::string& message) {
        const DbError error = refusal();
        EXPECT_EQ(error.kind(), kind);
        EXPECT_EQ(std::string(error.what()), m_file.string() + message);
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_file = m_folder / "sagara.db";
};

TEST_F(RefusedFile, OfANewerVersionIsNamedAndLeftAlone) {
    makeHealthy();
    executeIn(m_file, u"PRAGMA user_version = 7"_s);
    expectRefusal(Kind::Newer,
                  ": was written by a newer Sagara: has schema version 7, this program reads 1 to 3. "
                  "Update Sagara or choose another data folder; the file was left as it is.");
}

TEST_F(RefusedFile, OfAnotherApplicationIsNamedAndLeftAlone) {
    executeIn(m_file, u"CREATE TABLE places (url TEXT)"_s);
    expectRefusal(
        Kind::Foreign,
        ": belongs to another application (application id 0), expected a database of Sagara (1396787009). "
        "Choose another data folder; the file was left as it is.");
    executeIn(m_file, u"PRAGMA application_id = 252006674"_s);
    executeIn(m_file, u"PRAGMA journal_mode = WAL"_s);
    EXPECT_EQ(refusal().kind(), Kind::Foreign);
}

TEST_F(RefusedFile, WithoutAVersionIsDamaged) {
    executeIn(m_file, u"PRAGMA application_id = %1"_s.arg(kApplicationId));
    EXPECT_EQ(refusal().kind(), Kind::Damaged);
}

TEST_F(RefusedFile, ThatIsTextIsNotADatabase) {
    writeBytes(m_file, std::string(5000, 't'));
    expectRefusal(
        Kind::Damaged,
        ": this is not a database, or its beginning is damaged (file is not a database, SQLite 26). Move it "
        "and what lies beside it (-wal, -shm) away and put a backup in its place; it was left as it is.");
    writeBytes(m_file, "short");
    EXPECT_EQ(refusal().kind(), Kind::Damaged);
}

TEST_F(RefusedFile, ThatIsEmptyIsNotSilentlyStartedAfresh) {
    writeBytes(m_file, "");
    const DbError error = refusal();
    EXPECT_EQ(error.kind(), Kind::Damaged);
    EXPECT_NE(std::string(error.what()).find("holds 0 bytes, expected a database of Sagara"),
              std::string::npos);
}

TEST_F(RefusedFile, ThatIsAFolderIsNamed) {
    std::filesystem::create_directory(m_file);
    const DbError error = errorOf([this] { Database db(m_file); });
    EXPECT_EQ(error.kind(), Kind::CannotOpen);
    EXPECT_NE(std::string(error.what()).find("is no file that can be read: Is a directory"),
              std::string::npos);
}

TEST_F(RefusedFile, WhoseFolderCannotBeMadeIsNamed) {
    writeBytes(m_folder / "file", "");
    const DbError error = errorOf([this] { Database db(m_folder / "file/below/sagara.db"); });
    EXPECT_EQ(error.kind(), Kind::CannotOpen);
    EXPECT_NE(std::string(error.what()).find("the folder cannot be made: Not a directory"), std::string::npos)
        << error.what();
}

/// A flip that SQLite cannot know of (a letter within a text, an unused field) opens; any other is refused.
class FlippedByte : public RefusedFile {
protected:
    FlippedByte() {
        makeHealthy();
        m_healthy = readBytes(m_file);
    }
    void flipAndOpen(std::size_t at) {
        SCOPED_TRACE("byte " + std::to_string(at));
        std::string damaged = m_healthy;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x5a);
        writeBytes(m_file, damaged);
        const std::map<std::string, std::string> untouched{{"sagara.db", damaged}};
        if (!opens()) {
            EXPECT_EQ(contentsOf(m_folder.path()), untouched);
        }
        EXPECT_EQ(contentsOf(m_folder.path()).size(), 1u) << "something was left beside it";
    }
    std::string m_healthy;
    int m_refused = 0;

private:
    bool opens() {
        bool isOpen = false;
        try {
            Database db(m_file, std::chrono::milliseconds(50));
            isOpen = true;
            (void)db.integrity();
            (void)RunRepository(db).list();
        } catch (const DbError& error) {
            ++m_refused;
            EXPECT_NE(error.kind(), Kind::Locked) << error.what();
            EXPECT_TRUE(std::string(error.what()).starts_with(m_file.string())) << error.what();
        }
        return isOpen;
    }
};

TEST_F(FlippedByte, OfTheHeaderIsRefusedOrHarmless) {
    for (std::size_t at = 0; at < 100; ++at) flipAndOpen(at);
    EXPECT_GE(m_refused, 16 + 4 + 4);  // magic, application id, version; and what else SQLite looks at
}

TEST_F(FlippedByte, OfAPageIsRefusedOrHarmless) {
    for (std::size_t at = 100; at < m_healthy.size(); at += 331) flipAndOpen(at);
    for (std::size_t page = 4096; page < m_healthy.size(); page += 4096) flipAndOpen(page);
    EXPECT_GT(m_refused, 10);
}

TEST_F(RefusedFile, BrokenPageIsDamaged) {
    makeHealthy();
    std::string damaged = readBytes(m_file);
    for (std::size_t page = 4096; page < damaged.size(); page += 4096)
        damaged[page] = '\x5a';  // type of b-tree page
    writeBytes(m_file, damaged);
    const DbError error = refusal();
    EXPECT_EQ(error.kind(), Kind::Damaged);
    EXPECT_NE(std::string(error.what()).find("put a backup in its place"), std::string::npos) << error.what();
}

TEST_F(RefusedFile, CutOffIsDamaged) {
    makeHealthy();
    const std::string healthy = readBytes(m_file);
    for (const std::size_t length :
         {1u, 99u, 100u, 1000u, 4095u, 4096u, 4097u, 20'000u, unsigned(healthy.size() - 1)}) {
        writeBytes(m_file, healthy.substr(0, length));
        EXPECT_EQ(refusal().kind(), Kind::Damaged) << length;
    }
}

/// What a killed program leaves: everything it wrote last is in the log beside the file.
class CrashedWriter : public RefusedFile {
protected:
    void crashAfter(const QString& sql) {
        makeHealthy();
        TemporaryFolder live;
        std::filesystem::copy_file(m_file, live / "sagara.db");
        Connection writer(live / "sagara.db", Connection::Access::ReadWrite, kBusyTimeout);
        execute(writer, sql);
        for (const char* name : {"sagara.db", "sagara.db-wal"}) {
            std::filesystem::copy_file(live / name, m_folder / name,
                                       std::filesystem::copy_options::overwrite_existing);
        }
    }
};

TEST_F(CrashedWriter, LosesNothingThatWasCommitted) {
    crashAfter(u"INSERT INTO setting VALUES ('last', 'word')"_s);
    Database db(m_file);
    EXPECT_EQ(SettingRepository(db).find("last"), "word");
}

TEST_F(CrashedWriter, OfANewerVersionIsLeftAloneWithItsLog) {
    crashAfter(u"PRAGMA user_version = 7"_s);
    EXPECT_EQ(refusal().kind(), Kind::Newer);
}

TEST_F(CrashedWriter, WhoseLogIsDamagedLosesOnlyTheLog) {
    crashAfter(u"INSERT INTO setting VALUES ('last', 'word')"_s);
    std::string log = readBytes(m_folder / "sagara.db-wal");
    log[log.size() / 2] = static_cast<char>(log[log.size() / 2] ^ 0x5a);
    writeBytes(m_folder / "sagara.db-wal", log);
    Database db(m_file);
    EXPECT_FALSE(SettingRepository(db).find("last"));
    EXPECT_EQ(RunRepository(db).count(), 60);
}

}  // namespace
}  // namespace sagara::db
