#include <gtest/gtest.h>

#include "ui/roster/RosterCsv.h"

namespace sagara::ui::roster {
namespace {

CsvList listOf(const QByteArray& bytes) {
    const auto list = readCsv(bytes);
    EXPECT_TRUE(list) << (list ? "" : list.error().toStdString());
    return list ? *list : CsvList{};
}

std::string errorOf(const QByteArray& bytes) {
    const auto list = readCsv(bytes);
    return list ? "none" : list.error().toStdString();
}

TEST(RosterCsv, ColumnsMayComeInAnyOrderAndCase) {
    const CsvList list = listOf("Class,NOTE,Rank,name,Number\nWatch A,a@b.org,Cadet,Silva,17\n");
    ASSERT_EQ(list.rows.size(), 1u);
    const Person& p = list.rows[0].person;
    EXPECT_EQ(p.name, QStringLiteral("Silva"));
    EXPECT_EQ(p.number, QStringLiteral("17"));
    EXPECT_EQ(p.rank, QStringLiteral("Cadet"));
    EXPECT_EQ(p.className, QStringLiteral("Watch A"));
    EXPECT_EQ(p.note, QStringLiteral("a@b.org"));
    EXPECT_EQ(list.rows[0].line, 2);
    EXPECT_TRUE(list.rows[0].usable());
}

class Delimited : public testing::TestWithParam<const char*> {};
TEST_P(Delimited, IsRecognised) {
    const QByteArray d = GetParam();
    const CsvList list =
        listOf("name" + d + "rank\r\n\"Silva" + d + " A.\"" + d + "Cadet\r\nDias" + d + "\r\n");
    ASSERT_EQ(list.rows.size(), 2u);
    EXPECT_EQ(list.rows[0].person.name.toUtf8(), "Silva" + d + " A.") << "a tab is a fault, but read";
    EXPECT_EQ(list.rows[1].person.name, QStringLiteral("Dias"));
    EXPECT_EQ(list.delimiter, QLatin1Char(d[0]));
}
INSTANTIATE_TEST_SUITE_P(, Delimited, testing::Values(",", ";", "\t"));

TEST(RosterCsv, ByteOrderMarkQuotesAndOtherAlphabetsAreRead) {
    const CsvList list = listOf("\xEF\xBB\xBFname,note\n\"නිමල් \"\"Nim\"\" පෙරේරා\",\"a, b\"\n");
    ASSERT_EQ(list.rows.size(), 1u);
    EXPECT_EQ(list.rows[0].person.name, QStringLiteral("නිමල් \"Nim\" පෙරේරා"));
    EXPECT_EQ(list.rows[0].person.note, QStringLiteral("a, b"));
}

TEST(RosterCsv, EveryBadLineIsNamedWithWhatWasFoundAndWhatIsAccepted) {
    const QByteArray longName(81, 'x');
    const CsvList list =
        listOf("name,number\nSilva,1\n\n,2\nDias\nA,B,C\n" + longName + ",3\n\"two\nlines\",4\nLast,5\n");
    std::vector<std::pair<int, std::string>> faults;
    for (const CsvRow& row : list.rows)
        if (!row.fault.isEmpty()) faults.emplace_back(row.line, row.fault.toStdString());
    const std::vector<std::pair<int, std::string>> expected{
        {4, "the name is empty, expected 1 to 80 characters"},
        {5, "1 fields found, expected 2 as in line 1"},
        {6, "3 fields found, expected 2 as in line 1"},
        {7, "the name has 81 characters, expected up to 80"},
        {8, "the name goes over several lines or holds control characters, expected one line"}};
    EXPECT_EQ(faults, expected);
    EXPECT_EQ(list.rows.back().line, 10);
    EXPECT_TRUE(list.rows.back().usable());
}

TEST(RosterCsv, AQuotationMarkThatIsNotClosedIsAFault) {
    const CsvList list = listOf("name\n\"Silva\nDias\n");
    ASSERT_EQ(list.rows.size(), 1u);
    EXPECT_EQ(list.rows[0].fault,
              QStringLiteral("a quotation mark is not closed, expected one at the end of the field"));
}

TEST(RosterCsv, AFileThatIsNoListIsRefusedWithTheReason) {
    EXPECT_NE(errorOf("").find("The file is empty"), std::string::npos);
    EXPECT_NE(errorOf("name,rank\n").find("names no people"), std::string::npos);
    EXPECT_NE(errorOf("forename,rank\nA,B\n").find("no column \"name\" but \"forename\", \"rank\""),
              std::string::npos);
    EXPECT_NE(errorOf("name,Name\nA,B\n").find("twice"), std::string::npos);
    EXPECT_NE(errorOf("name\nJos\xe9\n").find("not UTF-8"), std::string::npos);
    EXPECT_NE(errorOf(QByteArray("name\nA\0B\n", 9)).find("not UTF-8"), std::string::npos);
    EXPECT_NE(errorOf(QByteArray(5 * 1024 * 1024, 'a')).find("5 MB"), std::string::npos);
}

TEST(RosterCsv, UnknownColumnsAreNamedAndIgnored) {
    const CsvList list = listOf("name,birthday\nSilva,1 Jan\n");
    EXPECT_EQ(list.ignored, QStringList{QStringLiteral("birthday")});
    EXPECT_TRUE(list.rows[0].usable());
}

TEST(RosterCsv, DoublesOfTheFileAndOfTheRosterAreMarked) {
    CsvList list = listOf("name,number\nSilva,1\nSilva,2\nDias,1\nPerera,7\nOld,9\nNew,\nNewer,\n");
    Person perera;
    perera.name = QStringLiteral("K. Perera");
    perera.number = QStringLiteral("7");
    Person retired;
    retired.name = QStringLiteral("Old");
    retired.retired = true;
    markDuplicates(list.rows, {perera, retired});
    EXPECT_TRUE(list.rows[0].usable());
    EXPECT_EQ(list.rows[1].duplicate, QStringLiteral("same name as line 2"));
    EXPECT_EQ(list.rows[2].duplicate, QStringLiteral("same number as line 2"));
    EXPECT_EQ(list.rows[3].duplicate, QStringLiteral("same number as K. Perera on the roster"));
    for (std::size_t i = 4; i < 7; ++i) EXPECT_TRUE(list.rows[i].usable()) << i;
}

TEST(RosterCsv, WhatIsWrittenIsReadAgain) {
    Person a, b;
    a.name = QStringLiteral("නිමල් \"Nim\", Perera");
    a.number = QStringLiteral("NA;17");
    a.note = QStringLiteral("a\tb");
    b.name = QStringLiteral("Dias");
    b.rank = QStringLiteral("Cadet");
    b.className = QStringLiteral("Watch A");
    const QByteArray bytes = writeCsv({a, b});
    EXPECT_TRUE(bytes.startsWith("\xEF\xBB\xBFname,number,rank,class,note\r\n"));
    const CsvList list = listOf(bytes);
    ASSERT_EQ(list.rows.size(), 2u);
    EXPECT_EQ(list.rows[0].person.name, a.name);
    EXPECT_EQ(list.rows[0].person.number, a.number);
    EXPECT_EQ(list.rows[0].person.note, a.note);
    EXPECT_EQ(list.rows[1].person.className, b.className);
}

TEST(RosterCsv, AnyBytesGiveAListOrAReason) {
    unsigned seed = 1;
    for (int i = 0; i < 3000; ++i) {
        QByteArray bytes = "name,number\n";
        for (int n = 0; n < 40; ++n) {
            seed = seed * 1664525u + 1013904223u;
            bytes.append("\",;\n\r\tab \xc3\xa9"[(seed >> 16) % 12]);
        }
        const auto list = readCsv(bytes);
        EXPECT_TRUE(!list || !list->rows.empty());
    }
}

}  // namespace
}  // namespace sagara::ui::roster
