#include "db/DocumentRepository.h"

#include <gtest/gtest.h>

#include "Support.h"
#include "core/base/Hash.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace test;
using namespace Qt::StringLiterals;

class EveryDocumentTable : public ::testing::TestWithParam<DocumentTable> {
protected:
    TemporaryFolder m_folder;
    Database m_db{m_folder / "sagara.db"};
    DocumentRepository m_documents{m_db, GetParam()};
};

TEST_P(EveryDocumentTable, FindsADocumentByItsKeyAsItWasGiven) {
    EXPECT_TRUE(m_documents.put(patrol(), kMorning));
    const auto found = m_documents.find("patrol51");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->text, patrol().text);
    EXPECT_EQ(found->entry.key, "patrol51");
    EXPECT_EQ(found->entry.name, "Patrol vessel");
    EXPECT_EQ(found->entry.contentHash, core::hashOf(patrol().text));
    EXPECT_EQ(found->entry.origin, Origin::Shipped);
    EXPECT_EQ(found->entry.changed, kMorning);
    EXPECT_FALSE(found->entry.retired);
    EXPECT_FALSE(m_documents.find("patrol5"));
}

TEST_P(EveryDocumentTable, PuttingTheSameAgainChangesNothing) {
    m_documents.put(patrol(), kMorning);
    EXPECT_FALSE(m_documents.put(patrol(), kNoon));
    EXPECT_EQ(m_documents.entry("patrol51")->changed, kMorning);
}

TEST_P(EveryDocumentTable, PuttingANewNameOrOriginIsAChangeWithoutHistory) {
    m_documents.put(patrol(), kMorning);
    NewDocument renamed = patrol();
    renamed.name = "Patrol";
    EXPECT_TRUE(m_documents.put(renamed, kNoon));
    renamed.origin = Origin::User;
    EXPECT_TRUE(m_documents.put(renamed, kNoon));
    EXPECT_EQ(m_documents.entry("patrol51")->name, "Patrol");
    EXPECT_EQ(m_documents.entry("patrol51")->origin, Origin::User);
    Query history(m_db.connection(), u"SELECT * FROM document_history"_s);
    EXPECT_FALSE(history.next());
}

TEST_P(EveryDocumentTable, ReplacedTextIsStillFoundByItsHash) {
    for (const char* text : {"{\"v\": 1}", "{\"v\": 2}", "{\"v\": 3}"})
        m_documents.put(patrol(text), kMorning);
    for (const char* text : {"{\"v\": 1}", "{\"v\": 2}", "{\"v\": 3}"}) {
        const auto version = m_documents.findByHash(core::hashOf(text));
        ASSERT_TRUE(version) << text;
        EXPECT_EQ(version->text, text);
        EXPECT_EQ(version->key, "patrol51");
    }
    EXPECT_FALSE(m_documents.findByHash(core::hashOf("{\"v\": 4}")));
}

TEST_P(EveryDocumentTable, ReturningToAnOldTextKeepsEachTextOnce) {
    for (const char* text : {"old", "new", "old", "new", "old"})
        EXPECT_TRUE(m_documents.put(patrol(text), kMorning));
    EXPECT_EQ(m_documents.find("patrol51")->text, "old");
    Query history(m_db.connection(), u"SELECT count(*) AS texts FROM document_history"_s);
    ASSERT_TRUE(history.next());
    EXPECT_EQ(history.integer(u"texts"_s), 2);
    EXPECT_TRUE(m_db.integrity().empty());
}

TEST_P(EveryDocumentTable, RetiredIsHiddenYetFoundAndStaysRetiredWhenReplaced) {
    m_documents.put(patrol(), kMorning);
    m_documents.retire("patrol51");
    EXPECT_TRUE(m_documents.inUse().empty());
    m_documents.put(patrol("{}"), kNoon);
    EXPECT_TRUE(m_documents.inUse().empty());
    EXPECT_EQ(m_documents.find("patrol51")->text, "{}");
    EXPECT_TRUE(m_documents.findByHash(core::hashOf("{}")));
    m_documents.restore("patrol51");
    EXPECT_EQ(m_documents.inUse().size(), 1u);
}

TEST_P(EveryDocumentTable, ListIsByName) {
    for (const char* name : {"Coaster", "Tug", "Ferry"}) {
        m_documents.put({.key = std::string(1, name[2]), .name = name, .text = "{}", .origin = Origin::User},
                        kMorning);
    }
    std::string names;
    for (const DocumentEntry& e : m_documents.inUse()) names += e.name + " ";
    EXPECT_EQ(names, "Coaster Ferry Tug ");
}

TEST_P(EveryDocumentTable, TextComesBackToTheByte) {
    const std::string texts[] = {"",
                                 "\xEF\xBB\xBF{\"bom\": true}",
                                 "\xff\xfe not UTF-8",
                                 std::string("nul\0inside", 10),
                                 "{\"name\": \"ගාල්ල\"}\r\n",
                                 std::string(3'000'000, 'x')};
    for (const std::string& text : texts) {
        m_documents.put(patrol(text), kMorning);
        EXPECT_EQ(m_documents.find("patrol51")->text, text);
    }
    for (const std::string& text : texts) EXPECT_EQ(m_documents.findByHash(core::hashOf(text))->text, text);
    EXPECT_TRUE(m_db.integrity().empty());
}

TEST_P(EveryDocumentTable, KeysAndNamesLikeSqlAreStoredVerbatim) {
    const std::string nasty = "x'); DROP TABLE vessel; --\"?:a%1";
    m_documents.put({.key = nasty, .name = nasty, .text = nasty, .origin = Origin::User}, kMorning);
    const auto found = m_documents.find(nasty);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->entry.key, nasty);
    EXPECT_EQ(found->entry.name, nasty);
    EXPECT_EQ(found->text, nasty);
}

TEST_P(EveryDocumentTable, TextThatNoLongerFitsItsHashIsRefused) {
    m_documents.put(patrol(), kMorning);
    execute(m_db.connection(),
            u"UPDATE %1 SET document = '{}'"_s.arg(QString::fromStdString(std::string(toText(GetParam())))));
    const DbError error = errorOf([this] { (void)m_documents.find("patrol51"); });
    EXPECT_EQ(error.kind(), DbError::Kind::Damaged);
    EXPECT_NE(std::string(error.what()).find("document patrol51 is not the one that was stored"),
              std::string::npos)
        << error.what();
}

INSTANTIATE_TEST_SUITE_P(All, EveryDocumentTable,
                         ::testing::Values(DocumentTable::Vessel, DocumentTable::Area,
                                           DocumentTable::Scenario),
                         [](const auto& row) { return std::string(toText(row.param)); });

TEST(DocumentTables, DoNotShareKeysOrHistory) {
    const TemporaryFolder folder;
    Database db(folder / "sagara.db");
    DocumentRepository vessels(db, DocumentTable::Vessel), areas(db, DocumentTable::Area);
    vessels.put(patrol("one"), kMorning);
    vessels.put(patrol("two"), kMorning);
    EXPECT_FALSE(areas.find("patrol51"));
    EXPECT_FALSE(areas.findByHash(core::hashOf("one")));
    EXPECT_FALSE(areas.findByHash(core::hashOf("two")));
}

}  // namespace
}  // namespace sagara::db
