// The roster's pages driven as a trainer would, without a display and without a database.
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDateTimeEdit>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <cstdlib>

#include "FakeRoster.h"
#include "ui/roster/PeoplePanel.h"
#include "ui/roster/ResultPage.h"
#include "ui/roster/RosterPage.h"
#include "ui/roster/Rows.h"
#include "ui/theme/Theme.h"

namespace sagara::ui::roster {
namespace {

using test::FakeResult;
using test::FakeRoster;

class PageTest : public ::testing::Test {
protected:
    template <typename Widget>
    Widget* find(const char* name) {
        auto* const widget = m_page->findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(widget, nullptr) << name;
        return widget;
    }
    void press(const char* name) {
        auto* const button = find<QPushButton>(name);
        ASSERT_TRUE(button->isEnabled()) << name;
        QTest::mouseClick(button, Qt::LeftButton);
    }
    void type(const char* name, const char* words) {
        find<QLineEdit>(name)->setText(QString::fromUtf8(words));
    }
    /// In every palette and at two sizes when pictures are wanted.
    void keepPictures(const QString& name, QWidget* of = nullptr) {
        const char* const folder = std::getenv("SAGARA_UI_PICTURES");
        if (folder == nullptr) return;
        const std::pair<PaletteName, const char*> palettes[] = {
            {PaletteName::Day, "day"}, {PaletteName::Dusk, "dusk"}, {PaletteName::Night, "night"}};
        for (const auto& [palette, word] : palettes) {
            applyTheme(*qApp, palette);
            m_page->setColours(palette);
            for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)}) {
                if (of == nullptr) m_page->resize(size);
                QApplication::processEvents();
                (of != nullptr ? of : m_page.get())
                    ->grab()
                    .save(QStringLiteral("%1/%2-%3-%4.png")
                              .arg(QString::fromUtf8(folder), name, QLatin1String(word))
                              .arg(size.width()));
            }
        }
        applyTheme(*qApp, PaletteName::Day);
        m_page->setColours(PaletteName::Day);
    }
    std::unique_ptr<Page> m_page;
};

class Roster : public PageTest {
protected:
    Roster() { open(); }
    void open() {
        auto port = std::make_unique<FakeRoster>();
        m_roster = port.get();
        m_page = std::make_unique<RosterPage>(std::move(port));
        m_page->resize(1280, 720);
        m_page->setColours(PaletteName::Day);
    }
    void show() {
        m_page->show();
        QApplication::processEvents();
    }
    void tab(int index) { find<QTabWidget>("roster-tabs")->setCurrentIndex(index); }
    QString writeFile(const QByteArray& bytes) {
        QFile file(m_folder.filePath(QStringLiteral("people.csv")));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        return file.fileName();
    }
    FakeRoster* m_roster = nullptr;
    QTemporaryDir m_folder;
};

TEST_F(Roster, ListsPeopleAndFindsThem) {
    show();
    auto* const people = find<RowsView>("people");
    EXPECT_EQ(people->shownRows(), 8);
    type("people-search", "midship 27-a");
    EXPECT_EQ(people->shownRows(), 3);
    type("people-search", "");
    find<QCheckBox>("people-retired")->setChecked(true);
    EXPECT_EQ(people->shownRows(), 9);
    people->select(1);
    EXPECT_EQ(find<QLineEdit>("person-name")->text(), QStringLiteral("Nimal Perera"));
    keepPictures(QStringLiteral("people"));
}

TEST_F(Roster, EmptyOnesSayWhatToDoNext) {
    m_roster->clear();
    show();
    EXPECT_EQ(find<RowsView>("people")->shownRows(), 0);
    keepPictures(QStringLiteral("people-empty"));
    tab(1);
    EXPECT_FALSE(find<QPushButton>("assign")->isEnabled());
    keepPictures(QStringLiteral("assignments-empty"));
    tab(2);
    keepPictures(QStringLiteral("runs-empty"));
}

TEST_F(Roster, SomebodyIsAdded) {
    show();
    press("person-add");
    EXPECT_FALSE(find<RowsView>("people")->isEnabled()) << "first save or cancel";
    type("person-name", " M. Jayawardena ");
    type("person-number", "NA-1800");
    find<QComboBox>("person-class")->setCurrentText(QStringLiteral("Watchkeeping 28-A"));
    keepPictures(QStringLiteral("person-new"));
    press("person-save");
    const Person* const added = m_roster->find(QStringLiteral("M. Jayawardena"));
    ASSERT_NE(added, nullptr);
    EXPECT_EQ(added->className, QStringLiteral("Watchkeeping 28-A"));
    EXPECT_TRUE(find<RowsView>("people")->isEnabled());
    EXPECT_EQ(find<RowsView>("people")->selectedId(), added->id);
}

TEST_F(Roster, BadEntriesAreToldAtTheFieldAndNotSaved) {
    show();
    find<RowsView>("people")->select(1);
    type("person-number", "NA-1702");
    EXPECT_FALSE(find<QPushButton>("person-save")->isEnabled());
    type("person-number", "NA-1701");
    type("person-name", "");
    EXPECT_FALSE(find<QPushButton>("person-save")->isEnabled());
    type("person-name", "Cdr. A. Silva");
    EXPECT_FALSE(find<QPushButton>("person-save")->isEnabled());
    keepPictures(QStringLiteral("person-fault"));
    press("person-cancel");
    EXPECT_EQ(find<QLineEdit>("person-name")->text(), QStringLiteral("Nimal Perera"));
    EXPECT_TRUE(m_page->mayLeave());
}

TEST_F(Roster, SomebodyIsRetiredAndTakenBack) {
    show();
    auto* const people = find<RowsView>("people");
    people->select(5);
    press("person-retire");
    EXPECT_TRUE(m_roster->find(QStringLiteral("Tharindu Bandara"))->retired);
    EXPECT_EQ(people->shownRows(), 7);
    find<QCheckBox>("people-retired")->setChecked(true);
    people->select(5);
    press("person-retire");
    EXPECT_FALSE(m_roster->find(QStringLiteral("Tharindu Bandara"))->retired);
}

TEST_F(Roster, ClassesAreAddedRenamedAndRetired) {
    show();
    press("classes");
    auto* const dialog = find<QDialog>("classes-dialog");
    type("class-name", "Watchkeeping 27-A");
    EXPECT_FALSE(find<QPushButton>("class-add")->isEnabled()) << "there is one";
    type("class-name", "Pilots");
    press("class-add");
    EXPECT_EQ(m_roster->classes().size(), 3u);
    find<RowsView>("class-list")->select(1);
    EXPECT_FALSE(find<QPushButton>("class-retire")->isEnabled()) << "people are in it";
    type("class-name", "Watch A");
    keepPictures(QStringLiteral("classes"), dialog);
    press("class-rename");
    EXPECT_EQ(m_roster->m_classes[1], QStringLiteral("Watch A"));
    find<RowsView>("class-list")->select(m_roster->m_classes.rbegin()->first);
    press("class-retire");
    EXPECT_EQ(m_roster->classes().size(), 2u);
    dialog->accept();
}

TEST_F(Roster, AFileIsLookedThroughAndOnlyTickedLinesAreTakenIn) {
    show();
    auto* const panel = m_page->findChild<PeoplePanel*>();
    panel->importFrom(
        writeFile("\xEF\xBB\xBFrank;name;number;class;note;hobby\r\n"
                  "Cadet;\"Perera; S.\";NC-01;Watchkeeping 28-A;s@academy.example;chess\r\n"
                  "Cadet;Ruwan Kumara;NC-02;Watchkeeping 28-A;;\r\n"
                  "Cadet;;NC-03;;;\r\n"
                  "Cadet;Nimal Perera;NC-04;;;\r\n"
                  "Cadet;too few\r\n"
                  "Cadet;Another;NC-01;;;\r\n"));
    auto* const rows = find<QTableWidget>("import-rows");
    ASSERT_EQ(rows->rowCount(), 6);
    EXPECT_EQ(rows->item(2, 7)->text(), QStringLiteral("the name is empty, expected 1 to 80 characters"));
    EXPECT_EQ(rows->item(3, 7)->text(), QStringLiteral("same name as Nimal Perera on the roster"));
    EXPECT_EQ(rows->item(4, 0)->text(), QStringLiteral("6"));
    EXPECT_FALSE(rows->item(4, 0)->flags() & Qt::ItemIsUserCheckable);
    EXPECT_EQ(find<QLabel>("import-summary")->text(),
              QStringLiteral("6 lines: 2 new, 2 double, 2 with a fault. Untick what is not to be taken in. "
                             "Not used: the columns hobby."));
    keepPictures(QStringLiteral("import"), find<QDialog>("import-dialog"));
    rows->item(1, 0)->setCheckState(Qt::Unchecked);
    EXPECT_EQ(find<QPushButton>("import-now")->text(), QStringLiteral("Import 1 person"));
    press("import-now");
    EXPECT_EQ(m_roster->m_people.size(), 10u);
    EXPECT_NE(m_roster->find(QStringLiteral("Perera; S.")), nullptr);
    EXPECT_EQ(m_roster->find(QStringLiteral("Ruwan Kumara")), nullptr);
    find<QMessageBox>("roster-box")->accept();
}

TEST_F(Roster, AnImportThatFailsSaysSoAndKeepsThePreview) {
    show();
    m_roster->m_importTrouble = QStringLiteral("the disk is full");
    m_page->findChild<PeoplePanel*>()->importFrom(writeFile("name\nSomebody\n"));
    press("import-now");
    EXPECT_TRUE(find<QDialog>("import-dialog")->isVisible());
    EXPECT_EQ(m_roster->m_people.size(), 9u);
}

TEST_F(Roster, AFileThatIsNoListIsAMessage) {
    show();
    m_page->findChild<PeoplePanel*>()->importFrom(writeFile("a,b\n1,2\n"));
    EXPECT_TRUE(find<QMessageBox>("roster-box")->text().contains(QStringLiteral("no column \"name\"")));
    find<QMessageBox>("roster-box")->accept();
}

TEST_F(Roster, ThePeopleShownAreWritten) {
    show();
    type("people-search", "27-B");
    const QString file = m_folder.filePath(QStringLiteral("out.csv"));
    m_page->findChild<PeoplePanel*>()->exportTo(file);
    QFile out(file);
    ASSERT_TRUE(out.open(QIODevice::ReadOnly));
    EXPECT_EQ(out.readAll(),
              "\xEF\xBB\xBFname,number,rank,class,note\r\n"
              "Tharindu Bandara,NA-1705,Midshipman,Watchkeeping 27-B,\r\n"
              "M. O'Brien,EX-12,Lieutenant,Watchkeeping 27-B,exchange officer until June\r\n");
    find<QMessageBox>("roster-box")->accept();
}

TEST_F(Roster, AMissionIsAssignedAndWithdrawn) {
    show();
    find<RowsView>("people")->select(2);
    press("person-assign");
    EXPECT_EQ(find<QTabWidget>("roster-tabs")->currentIndex(), 1);
    EXPECT_EQ(find<QComboBox>("assign-whom")->currentData().toLongLong(), 2);
    EXPECT_FALSE(find<QPushButton>("assign")->isEnabled());
    find<QComboBox>("assign-mission")->setCurrentIndex(1);
    auto* const due = find<QDateTimeEdit>("assign-due");
    const QDateTime later = due->dateTime();
    due->setDateTime(QDateTime::fromSecsSinceEpoch(m_roster->now().unix_s - 60));
    EXPECT_FALSE(find<QPushButton>("assign")->isEnabled()) << "in the past";
    due->setDateTime(later);
    find<QComboBox>("assign-type")->setCurrentIndex(1);
    press("assign");
    ASSERT_EQ(m_roster->m_assignments.size(), 4u);
    const Assignment& a = m_roster->m_assignments.back();
    EXPECT_EQ(a.mission, QStringLiteral("Heavy Weather"));
    EXPECT_EQ(a.personId, 2);
    EXPECT_EQ(a.type, QStringLiteral("assess"));
    EXPECT_GT(a.due.unix_s, m_roster->now().unix_s);
    auto* const table = find<RowsView>("assignments");
    table->select(1);
    EXPECT_EQ(find<RowsView>("members")->shownRows(), 4);
    keepPictures(QStringLiteral("assignments"));
    press("withdraw");
    EXPECT_EQ(m_roster->m_assignments[0].state, State::Withdrawn);
    EXPECT_EQ(table->shownRows(), 3);
}

TEST_F(Roster, RunsAreFilteredAndOpened) {
    show();
    find<RowsView>("people")->select(1);
    press("person-runs");
    auto* const runs = find<RowsView>("runs");
    EXPECT_EQ(runs->shownRows(), 2);
    EXPECT_EQ(find<QLabel>("history-summary")->text(), QStringLiteral("2 runs: 1 graded, 1 for practice"));
    press("history-all");
    EXPECT_EQ(runs->shownRows(), 7);
    runs->select(8);
    keepPictures(QStringLiteral("runs"));
    press("run-debrief");
    EXPECT_EQ(m_roster->m_opened, 8);
    m_roster->m_opened = 0;
    runs->setFocus();
    QTest::keyClick(runs, Qt::Key_Return);
    EXPECT_EQ(m_roster->m_opened, 8);
}

TEST_F(Roster, AReportIsWrittenInTheBackground) {
    show();
    tab(2);
    find<RowsView>("runs")->select(8);
    press("run-report");
    const QString file = m_folder.filePath(QStringLiteral("report.pdf"));
    Q_EMIT find<QFileDialog>("report-file")->fileSelected(file);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return m_page->findChild<QMessageBox*>(QStringLiteral("report-done")) != nullptr; }, 5000));
    EXPECT_TRUE(QFile::exists(file));
    find<QMessageBox>("report-done")->accept();
    find<QFileDialog>("report-file")->reject();
}

TEST_F(Roster, ADatabaseThatCannotBeReachedIsTold) {
    m_roster->clear();
    m_roster->m_trouble = QStringLiteral("another program kept the database locked for 5 s");
    show();
    EXPECT_TRUE(find<QLabel>("roster-trouble")->text().contains(QStringLiteral("locked")));
}

class ResultOfARun : public PageTest {
protected:
    void open(std::unique_ptr<FakeResult> port) {
        m_port = port.get();
        m_page = std::make_unique<ResultPage>(std::move(port));
        m_page->setColours(PaletteName::Day);
        m_page->resize(1280, 720);
        m_page->show();
        QApplication::processEvents();
    }
    void SetUp() override { open(std::make_unique<FakeResult>()); }
    FakeResult* m_port = nullptr;
};

TEST_F(ResultOfARun, ShowsTheAutomaticScoreAsAdviceWithTasksAndDeductions) {
    EXPECT_EQ(find<QLabel>("result-score")->text(), QStringLiteral("58.5 of 100"));
    EXPECT_EQ(find<QLabel>("result-advice")->text(), QStringLiteral("automatic score, advisory"));
    EXPECT_EQ(find<QLabel>("result-verdict")->text(), QStringLiteral("NOT PASSED"));
    EXPECT_EQ(find<RowsView>("result-tasks")->shownRows(), 4);
    EXPECT_EQ(find<RowsView>("result-losses")->shownRows(), 3);
    EXPECT_TRUE(m_page->mayLeave());
    keepPictures(QStringLiteral("result"));
}

TEST_F(ResultOfARun, OverrulingNeedsAReason) {
    find<QCheckBox>("overrule")->setChecked(true);
    find<QDoubleSpinBox>("overruled-score")->setValue(72.0);
    find<QComboBox>("overruled-passed")->setCurrentIndex(0);
    EXPECT_FALSE(find<QPushButton>("assessment-save")->isEnabled());
    keepPictures(QStringLiteral("result-no-reason"));
    find<QPlainTextEdit>("assessor-reason")->setPlainText(QStringLiteral("The squall came out of season."));
    press("assessment-save");
    EXPECT_TRUE(m_port->m_result.entry.overrule);
    EXPECT_EQ(m_port->m_result.entry.score, 72.0);
    EXPECT_EQ(find<QLabel>("result-score")->text(), QStringLiteral("72 of 100"));
    EXPECT_EQ(find<QLabel>("result-verdict")->text(), QStringLiteral("PASSED"));
    EXPECT_TRUE(find<QLabel>("result-advice")
                    ->text()
                    .contains(QStringLiteral("automatic: 58.5, not passed (advisory)")));
}

TEST_F(ResultOfARun, AfterTheSignOffItCanOnlyBeRead) {
    find<QPlainTextEdit>("assessor-comment")->setPlainText(QStringLiteral("Kept a good look-out."));
    EXPECT_FALSE(find<QPushButton>("sign-off")->isEnabled()) << "nobody is chosen";
    find<QComboBox>("signed-by")->setCurrentIndex(0);
    press("sign-off");
    auto* const box = find<QMessageBox>("sign-box");
    for (QAbstractButton* button : box->buttons())
        if (box->buttonRole(button) == QMessageBox::AcceptRole) button->click();
    EXPECT_EQ(m_port->m_result.signedBy, QStringLiteral("Cdr. A. Silva"));
    EXPECT_EQ(m_port->m_result.entry.comment, QStringLiteral("Kept a good look-out."));
    EXPECT_TRUE(find<QPlainTextEdit>("assessor-comment")->isReadOnly());
    EXPECT_FALSE(find<QPushButton>("sign-off")->isVisible());
    EXPECT_TRUE(find<QLabel>("assessment-state")
                    ->text()
                    .startsWith(QStringLiteral("Signed off by Cdr. A. Silva on ")));
    keepPictures(QStringLiteral("result-signed"));
}

TEST_F(ResultOfARun, WithoutATrainerOnTheRosterItSaysSo) {
    auto port = std::make_unique<FakeResult>();
    port->m_assessors.clear();
    open(std::move(port));
    EXPECT_FALSE(find<QPushButton>("sign-off")->isEnabled());
}

TEST_F(ResultOfARun, ThatIsNotFiledCannotBeAssessedYet) {
    auto port = std::make_unique<FakeResult>();
    port->m_result.cannotAssess = QStringLiteral("This run is not in the database yet.");
    open(std::move(port));
    EXPECT_TRUE(find<QPlainTextEdit>("assessor-comment")->isReadOnly());
    EXPECT_FALSE(find<QPushButton>("assessment-save")->isVisible());
}

}  // namespace
}  // namespace sagara::ui::roster

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    sagara::ui::applyTheme(application, sagara::ui::PaletteName::Day);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
