#include "ui/help/HelpBook.h"

#include <gtest/gtest.h>

namespace sagara::ui {
namespace {

const std::filesystem::path kHelp = std::filesystem::path(SAGARA_ASSETS) / "help";

TEST(HelpBook, TheShippedPagesBeginWithATitleAndLinkToPagesThatAreThere) {
    const HelpBook book(kHelp);
    ASSERT_GE(book.pages().size(), 5);
    EXPECT_EQ(book.pages()[0].topic.toStdString(), "index");
    for (const HelpBook::Page& page : book.pages()) {
        EXPECT_TRUE(page.text.startsWith(QStringLiteral("# "))) << page.topic.toStdString();
        EXPECT_FALSE(page.title.isEmpty());
    }
    for (const char* topic : {"start", "desk", "keys", "practise", "demo", "walks"})
        EXPECT_NE(book.find(QString::fromLatin1(topic)), nullptr) << topic;
}

TEST(HelpBook, FindsPagesWithAllWordsTitlesFirst) {
    const HelpBook book(kHelp);
    const auto found = book.search(QStringLiteral("exhibition pin"));
    ASSERT_FALSE(found.isEmpty());
    EXPECT_EQ(found[0].topic.toStdString(), "demo");
    EXPECT_FALSE(found[0].excerpt.contains(QLatin1Char('*'))) << "plain words";
    EXPECT_TRUE(book.search(QStringLiteral("xyzzy")).isEmpty());
    EXPECT_TRUE(book.search(QStringLiteral("   ")).isEmpty());
}

TEST(HelpBook, AFolderThatIsNotThereIsAnEmptyBook) {
    const HelpBook book("/nowhere/at/all");
    EXPECT_TRUE(book.pages().isEmpty());
    EXPECT_EQ(book.find(QStringLiteral("index")), nullptr);
}

}  // namespace
}  // namespace sagara::ui
