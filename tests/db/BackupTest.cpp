#include <gtest/gtest.h>

#include "Support.h"
#include "db/SettingRepository.h"
#include "db/Transaction.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace test;
using namespace Qt::StringLiterals;
using Kind = DbError::Kind;
namespace fs = std::filesystem;

class Backup : public ::testing::Test {
protected:
    Backup() { SettingRepository(m_db).put("who", "original"); }
    std::string messageOf(const fs::path& copy, Database::Existing existing = Database::Existing::Refuse) {
        return errorOf([&] { m_db.backupTo(copy, existing); }).what();
    }
    /// One file per element: whatever lies in the folder.
    std::string names() const {
        std::string all;
        for (const auto& [name, bytes] : contentsOf(m_copies.path())) all += name + " ";
        return all;
    }
    TemporaryFolder m_folder, m_copies;
    Database m_db{m_folder / "sagara.db"};
    fs::path m_copy = m_copies / "copy.db";
};

TEST_F(Backup, IsADatabaseWithTheSameRows) {
    DocumentRepository(m_db, DocumentTable::Vessel).put(patrol(), kMorning);
    m_db.backupTo(m_copy);
    EXPECT_EQ(names(), "copy.db ");
    Database copy(m_copy);
    EXPECT_EQ(SettingRepository(copy).find("who"), "original");
    EXPECT_EQ(DocumentRepository(copy, DocumentTable::Vessel).find("patrol51")->text, patrol().text);
    EXPECT_TRUE(copy.integrity().empty());
    EXPECT_EQ(copy.info().schemaVersion, m_db.info().schemaVersion);
}

TEST_F(Backup, ExistingFileIsReplacedOnlyWhenAsked) {
    writeBytes(m_copy, "my only photograph");
    EXPECT_EQ(messageOf(m_copy), m_copy.string() +
                                     ": no backup was made: the file exists and it was not asked to "
                                     "overwrite it. Choose another name.");
    EXPECT_EQ(readBytes(m_copy), "my only photograph");
    m_db.backupTo(m_copy, Database::Existing::Overwrite);
    EXPECT_EQ(SettingRepository(*std::make_unique<Database>(m_copy)).find("who"), "original");
}

TEST_F(Backup, NeverReplacesTheDatabaseItself) {
    const fs::path itself = m_folder / "sagara.db";
    EXPECT_NE(messageOf(itself, Database::Existing::Overwrite).find("no backup was made"), std::string::npos);
    fs::create_symlink(itself, m_copies / "link.db");
    EXPECT_NE(
        messageOf(m_copies / "link.db", Database::Existing::Overwrite).find("that is the database itself"),
        std::string::npos);
    EXPECT_TRUE(m_db.integrity().empty());
}

TEST_F(Backup, NeverReplacesADatabaseThatIsOpen) {
    Database open(m_copy);
    const std::string message = messageOf(m_copy, Database::Existing::Overwrite);
    EXPECT_NE(message.find("a program has that file open"), std::string::npos) << message;
}

TEST_F(Backup, MissingFolderIsNamed) {
    const std::string message = messageOf(m_copies / "no/copy.db");
    EXPECT_NE(message.find("there is no such folder"), std::string::npos) << message;
}

TEST_F(Backup, EmptyNameIsRefused) {
    EXPECT_EQ(messageOf(""), ": no backup was made: the name is empty. Choose another name.");
}

TEST_F(Backup, FolderInItsPlaceIsNamed) {
    EXPECT_NE(messageOf(m_copies.path(), Database::Existing::Overwrite).find("that is not a file"),
              std::string::npos);
}

TEST_F(Backup, WithinATransactionIsRefusedAndLeavesNothing) {
    Transaction transaction(m_db);
    EXPECT_NE(messageOf(m_copy).find("no backup was made"), std::string::npos);
    EXPECT_EQ(names(), "");
}

TEST_F(Backup, RelativeNameIsFromTheWorkingFolder) {
    const fs::path before = fs::current_path();
    fs::current_path(m_copies.path());
    m_db.backupTo("here.db");
    fs::current_path(before);
    EXPECT_EQ(names(), "here.db ");
}

TEST_F(Backup, NameLikeSqlOrAUriIsTakenAsItIs) {
    m_db.backupTo(m_copies / "it's ?mode=memory&x=%41.db");
    EXPECT_EQ(names(), "it's ?mode=memory&x=%41.db ");
}

TEST(BackupOnAHiddenFolder, IsReadOnly) {
    const TemporaryFolder folder, copies;
    { Database make(folder / "sagara.db"); }
    fs::permissions(folder / "sagara.db", fs::perms(0666));
    fs::permissions(copies.path(), fs::perms(0));
    const std::string error =
        errorAsOrdinaryUser([&] { Database(folder / "sagara.db").backupTo(copies / "copy.db"); });
    EXPECT_TRUE(error.starts_with(kindPrefix(Kind::ReadOnly))) << error;
}

TEST(BackupOnAReadOnlyFolder, IsReadOnlyAndLeavesNothing) {
    const TemporaryFolder folder, copies;
    { Database make(folder / "sagara.db"); }
    fs::permissions(folder / "sagara.db", fs::perms(0666));
    fs::permissions(copies.path(), fs::perms(0555));
    const std::string error =
        errorAsOrdinaryUser([&] { Database(folder / "sagara.db").backupTo(copies / "copy.db"); });
    EXPECT_TRUE(error.starts_with(kindPrefix(Kind::ReadOnly) + (copies / "copy.db").string() +
                                  ": no backup was made"))
        << error;
    EXPECT_TRUE(fs::is_empty(copies.path()));
}

}  // namespace
}  // namespace sagara::db
