#include "ui/help/HelpWindow.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <QTextBrowser>

#include "tests/support/Assets.h"
#include "ui/help/AboutDialog.h"
#include "ui/theme/Theme.h"

namespace sagara::ui {
namespace {

const std::filesystem::path kHelp = std::filesystem::path(SAGARA_ASSETS) / "help";

template <typename Widget>
Widget* find(QWidget& window, const char* name) {
    auto* const widget = window.findChild<Widget*>(QString::fromLatin1(name));
    EXPECT_NE(widget, nullptr) << name;
    return widget;
}

void keepPicture(QWidget& window, const QString& name) {
    const QString folder = qEnvironmentVariable("SAGARA_UI_PICTURES");
    if (folder.isEmpty()) return;
    QApplication::processEvents();
    window.grab().save(folder + QLatin1Char('/') + name);
}

TEST(HelpWindow, ShowsATopicFollowsLinksAndGoesBack) {
    HelpWindow help{HelpBook(kHelp), PaletteName::Day};
    help.showTopic(QStringLiteral("demo"));
    auto* const page = find<QTextBrowser>(help, "help-page");
    EXPECT_EQ(help.topic().toStdString(), "demo");
    EXPECT_FALSE(find<QPushButton>(help, "help-back")->isEnabled());
    Q_EMIT page->anchorClicked(QUrl(QStringLiteral("keys.md")));
    EXPECT_EQ(help.topic().toStdString(), "keys");
    QTest::mouseClick(find<QPushButton>(help, "help-back"), Qt::LeftButton);
    EXPECT_EQ(help.topic().toStdString(), "demo");
    QTest::mouseClick(find<QPushButton>(help, "help-forward"), Qt::LeftButton);
    EXPECT_EQ(help.topic().toStdString(), "keys");
    EXPECT_FALSE(find<QPushButton>(help, "help-forward")->isEnabled());
}

TEST(HelpWindow, SearchesAndOpensWhatIsChosen) {
    HelpWindow help{HelpBook(kHelp), PaletteName::Day};
    help.showTopic(QStringLiteral("index"));
    auto* const contents = find<QListWidget>(help, "help-contents");
    const int all = contents->count();
    QTest::keyClicks(find<QLineEdit>(help, "help-search"), QStringLiteral("stars"));
    ASSERT_GE(contents->count(), 1);
    EXPECT_LT(contents->count(), all);
    contents->setCurrentRow(0);
    EXPECT_EQ(help.topic().toStdString(), "demo");
    find<QLineEdit>(help, "help-search")->setText(QStringLiteral("xyzzy"));
    ASSERT_EQ(contents->count(), 1);
    EXPECT_TRUE(contents->item(0)->text().contains(QStringLiteral("No page")));
}

TEST(HelpWindow, ATopicThatIsNotThereSaysSoOverTheContents) {
    HelpWindow help{HelpBook(kHelp), PaletteName::Day};
    help.showTopic(QStringLiteral("nonsense"));
    EXPECT_EQ(help.topic().toStdString(), "index");
    EXPECT_TRUE(find<QTextBrowser>(help, "help-page")->toPlainText().contains(QStringLiteral("nonsense")));
}

TEST(HelpWindow, ThereIsOneForAWindow) {
    QWidget window;
    showHelp(&window, kHelp, QStringLiteral("start"), PaletteName::Day);
    showHelp(&window, kHelp, QStringLiteral("keys"), PaletteName::Night);
    const auto all = window.findChildren<HelpWindow*>();
    ASSERT_EQ(all.size(), 1);
    EXPECT_EQ(all[0]->topic().toStdString(), "keys");
}

TEST(AboutDialog, NamesVersionLicenceBuildAndEverybody) {
    AboutFacts facts;
    facts.version = QStringLiteral("0.1.0");
    facts.buildId = QStringLiteral("abc123");
    facts.attributions = QString::fromStdString(test::readAsset("ATTRIBUTION.md"));
    facts.credits = {
        {QStringLiteral("Area: Galle"), attributionOf(test::readAsset("areas/galle/area.json"))}};
    ASSERT_GE(facts.credits[0].lines.size(), 3);
    AboutDialog about(facts);
    const QString words = find<QLabel>(about, "about-words")->text();
    EXPECT_TRUE(words.contains(QStringLiteral("GPL-3.0-or-later")));
    EXPECT_TRUE(words.contains(QStringLiteral("abc123")));
    EXPECT_TRUE(
        find<QTextBrowser>(about, "about-credits")->toPlainText().contains(QStringLiteral("TICON-4")));
    EXPECT_TRUE(find<QTextBrowser>(about, "about-attributions")
                    ->toPlainText()
                    .contains(QStringLiteral("FlightGear")));
    EXPECT_TRUE(attributionOf("{\"attribution\": \"one\"}") == QStringList(QStringLiteral("one")));
    EXPECT_TRUE(attributionOf("no json").isEmpty());
}

TEST(HelpPictures, OfAllPalettes) {
    for (const auto& [palette, name] : {std::pair{PaletteName::Day, "day"}, {PaletteName::Night, "night"}}) {
        applyTheme(*static_cast<QApplication*>(QCoreApplication::instance()), palette);
        HelpWindow help{HelpBook(kHelp), palette};
        help.showTopic(QStringLiteral("keys"));
        keepPicture(help, QStringLiteral("help-%1.png").arg(QString::fromLatin1(name)));
        AboutFacts facts;
        facts.version = QStringLiteral("0.1.0");
        facts.buildId = QStringLiteral("3f6c1a");
        facts.attributions = QString::fromStdString(test::readAsset("ATTRIBUTION.md"));
        facts.credits = {{QStringLiteral("Area: Galle, Sri Lanka"),
                          attributionOf(test::readAsset("areas/galle/area.json"))}};
        AboutDialog about(facts);
        about.show();
        keepPicture(about, QStringLiteral("about-%1.png").arg(QString::fromLatin1(name)));
    }
}

}  // namespace
}  // namespace sagara::ui
