#include "db/Transaction.h"

#include <gtest/gtest.h>

#include "Support.h"
#include "db/SettingRepository.h"

namespace sagara::db {
namespace {

using namespace test;

class Transactions : public ::testing::Test {
protected:
    TemporaryFolder m_folder;
    Database m_db{m_folder / "sagara.db"};
    SettingRepository m_settings{m_db};
};

TEST_F(Transactions, CommittedIsKept) {
    Transaction transaction(m_db);
    m_settings.put("a", "1");
    transaction.commit();
    EXPECT_EQ(m_settings.find("a"), "1");
}

TEST_F(Transactions, NotCommittedIsRolledBack) {
    {
        Transaction transaction(m_db);
        m_settings.put("a", "1");
    }
    EXPECT_FALSE(m_settings.find("a"));
}

TEST_F(Transactions, ExceptionRollsBack) {
    const auto fail = [this] {
        Transaction transaction(m_db);
        m_settings.put("a", "1");
        throw std::runtime_error("something else");
    };
    EXPECT_THROW(fail(), std::runtime_error);
    EXPECT_FALSE(m_settings.find("a"));
    m_settings.put("a", "2");  // and the database is usable
    EXPECT_EQ(m_settings.find("a"), "2");
}

TEST_F(Transactions, AnotherConnectionSeesNothingBeforeTheCommit) {
    Database other(m_folder / "sagara.db");
    Transaction transaction(m_db);
    m_settings.put("a", "1");
    EXPECT_FALSE(SettingRepository(other).find("a"));
    transaction.commit();
    EXPECT_TRUE(SettingRepository(other).find("a"));
}

TEST_F(Transactions, InnerOneIsUndoneAlone) {
    Transaction outer(m_db);
    m_settings.put("outer", "1");
    {
        Transaction inner(m_db);
        m_settings.put("inner", "1");
    }
    {
        Transaction inner(m_db);
        m_settings.put("second", "1");
        inner.commit();
    }
    outer.commit();
    EXPECT_EQ(m_settings.all().size(), 2u);
    EXPECT_FALSE(m_settings.find("inner"));
}

TEST_F(Transactions, OuterOneUndoesCommittedInnerOnes) {
    {
        Transaction outer(m_db);
        DocumentRepository(m_db, DocumentTable::Area).put(patrol(), kMorning);  // has one of its own
        fileRun(m_db, {lesson(), ended(), good()});
    }
    EXPECT_FALSE(DocumentRepository(m_db, DocumentTable::Area).find("patrol51"));
    EXPECT_EQ(RunRepository(m_db).count(), 0);
}

}  // namespace
}  // namespace sagara::db
