// Sailing alone, driven as a person would: choice, run, result, replay, history.
#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableWidget>
#include <QTest>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "FakeFrame.h"
#include "app/station/PractiseDoor.h"
#include "db/AssignmentRepository.h"
#include "db/RunRepository.h"
#include "ui/hints/HintsPanel.h"
#include "ui/practise/PractisePage.h"
#include "ui/practise/SailResultPage.h"

namespace sagara::station {
namespace {

/// A console as small as can be.
class SmallConsole final : public ui::Page {
public:
    SmallConsole(ui::ExerciseRun& exercise, PractiseOptions given) : run(exercise), options(given) {
        auto* const layout = new QVBoxLayout(this);
        if (given.hints) layout->addWidget(new ui::HintsPanel(exercise, this));
    }
    QString helpTopic() const override { return QStringLiteral("practise"); }
    ui::ExerciseRun& run;
    PractiseOptions options;
};

class Practise : public FakeStation {
protected:
    void open() {
        PractiseWays ways;
        ways.console = [this](ui::ExerciseRun& run, const PractiseOptions& options) {
            return m_console = new SmallConsole(run, options);
        };
        ways.debrief = [this](const std::filesystem::path& recording,
                              double time_s) -> std::optional<std::string> {
            m_debriefed = {recording, time_s};
            return std::nullopt;
        };
        frame().openPage(practisePage(frame(), std::move(ways)));
        m_page = frame().page<ui::PractisePage>();
        ASSERT_NE(m_page, nullptr);
    }
    template <typename Widget>
    Widget* find(const char* name, QWidget* in = nullptr) {
        auto* const widget = (in ? in : &window())->findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(widget, nullptr) << name;
        return widget;
    }
    bool ready() {
        return QTest::qWaitFor([&] { return find<QPushButton>("set-sail", m_page)->isEnabled(); }, 30'000);
    }
    void chooseLesson(const char* name) {
        auto* const list = find<QListWidget>("lessons", m_page);
        const auto found = list->findItems(QString::fromLatin1(name), Qt::MatchExactly);
        ASSERT_EQ(found.size(), 1);
        list->setCurrentItem(found[0]);
        ASSERT_TRUE(ready());
    }
    void setSail() {
        QTest::mouseClick(find<QPushButton>("set-sail", m_page), Qt::LeftButton);
        ASSERT_TRUE(QTest::qWaitFor([&] { return m_console && m_console->isVisible(); }, 30'000));
    }
    ui::SailResultPage* result() {
        ui::SailResultPage* page = nullptr;
        EXPECT_TRUE(
            QTest::qWaitFor([&] { return (page = frame().page<ui::SailResultPage>()) != nullptr; }, 20'000));
        return page;
    }

    ui::PractisePage* m_page = nullptr;
    QPointer<SmallConsole> m_console;
    std::pair<std::filesystem::path, double> m_debriefed;
};

TEST_F(Practise, ShowsTheBriefingOfALessonAndTakesItsWeather) {
    open();
    chooseLesson("Heavy Weather");
    EXPECT_TRUE(find<QTextBrowser>("preview")->toPlainText().contains(QStringLiteral("south-west monsoon")));
    EXPECT_EQ(find<QSpinBox>("wind")->value(), 30);
    EXPECT_FALSE(find<QSpinBox>("wind")->isVisible());
    find<QCheckBox>("own-weather")->setChecked(true);
    EXPECT_TRUE(find<QSpinBox>("wind")->isVisible());
}

TEST_F(Practise, ALessonIsSailedAsSelfStudyWithItsResultReplayAndHistory) {
    open();
    find<QComboBox>("person")->setEditText(QStringLiteral("Nimal Perera"));
    chooseLesson("Heavy Weather");
    find<QCheckBox>("prediction")->setChecked(false);
    setSail();
    EXPECT_FALSE(m_console->options.prediction);
    EXPECT_TRUE(m_console->options.hints);
    m_console->run.setRate(20.0);
    m_console->run.start();
    m_console->run.give(0, core::AutopilotOrder{core::AutopilotMode::Heading, 2.9});  // out of the corridor
    ASSERT_TRUE(QTest::qWaitFor([&] { return m_console->run.latest()->time().seconds() > 150.0; }, 60'000));
    m_console->run.give(0, core::FinishOrder{});
    auto* const page = result();  // by itself, when the exercise is over
    ASSERT_NE(page, nullptr);
    keepPicture("practise-result.png");
    auto* const losses = find<QTableWidget>("result-losses", page);
    ASSERT_GE(losses->rowCount(), 1);
    QTest::mouseClick(find<QPushButton>("replay-0", page), Qt::LeftButton);
    EXPECT_TRUE(std::filesystem::exists(m_debriefed.first));
    EXPECT_GE(m_debriefed.second, 0.0);
    const auto runs = db::RunRepository(*store().database()).list();
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(runs[0].start.type, db::RunType::SelfStudy);
    EXPECT_EQ(runs[0].start.scenarioKey, "heavy-weather");
    EXPECT_TRUE(find<QLabel>("result-best", page)->text().contains(QStringLiteral("Your best here")));
    frame().leave();
    m_page->refresh();
    EXPECT_EQ(find<QTableWidget>("runs", m_page)->rowCount(), 1);
    EXPECT_TRUE(find<QLabel>("best", m_page)->text().contains(QStringLiteral("level 3")));
}

TEST_F(Practise, FreeSailingInWeatherOfOnesOwnEndsWhenTheConsoleIsLeft) {
    open();
    find<QTabWidget>("what")->setCurrentIndex(1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return find<QComboBox>("place", m_page)->count() > 3; }, 30'000));
    auto* const ship = find<QComboBox>("ship");
    ship->setCurrentIndex(ship->findData(QStringLiteral("patrol51")));
    auto* const place = find<QComboBox>("place");
    place->setCurrentIndex(place->findData(QStringLiteral("anch_ne_monsoon")));
    find<QSpinBox>("wind")->setValue(25);
    keepPicture("practise-free.png");
    ASSERT_TRUE(ready());
    setSail();
    EXPECT_EQ(m_console->run.world()->scenarioId, "free-sailing");
    EXPECT_NEAR(m_console->run.world()->weather.wind.speed_mps, 12.86, 0.01);
    m_console->run.start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return m_console->run.latest()->tick > 20; }, 10'000));
    frame().leave();
    auto* const page = result();
    ASSERT_NE(page, nullptr);
    EXPECT_TRUE(find<QLabel>("result-line", page)->text().contains(QStringLiteral("Nothing was graded")));
    keepPicture("practise-free-result.png");
    QTest::mouseClick(find<QPushButton>("again", page), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return m_console && m_console->isVisible(); }, 20'000));
    EXPECT_EQ(m_console->run.latest()->tick, 0);
    frame().dropPages();  // the window is closed: run and console go in any order
}

TEST_F(Practise, AnAssignmentIsListedWithItsDateAndChoosesItsLesson) {
    auto& database = *store().database();
    const auto person = db::PersonRepository(database).add("Kumari Silva", db::Role::Trainee, run::now());
    ASSERT_TRUE(person);
    db::NewAssignment given;
    given.scenarioKey = "heavy-weather";
    given.scenarioName = "Heavy Weather";
    given.forWhom = *person;
    given.due = {run::now().unix_s + 7 * 86'400};
    given.type = db::RunType::SelfStudy;
    given.level = 4;
    ASSERT_TRUE(db::AssignmentRepository(database).add(given, run::now()));
    open();
    ASSERT_TRUE(ready());
    find<QComboBox>("person")->setEditText(QStringLiteral("Kumari Silva"));
    auto* const table = find<QTableWidget>("assignments");
    ASSERT_TRUE(QTest::qWaitFor([&] { return table->rowCount() == 1; }, 10'000));
    EXPECT_EQ(table->item(0, 0)->text().toStdString(), "Heavy Weather");
    table->setCurrentCell(0, 0);
    ASSERT_TRUE(ready());
    EXPECT_EQ(find<QListWidget>("lessons")->currentItem()->text().toStdString(), "Heavy Weather");
    EXPECT_EQ(find<QComboBox>("level")->currentData().toInt(), 4);
}

TEST_F(Practise, ANameThatIsNoneSaysWhyAndKeepsTheShipInPort) {
    open();
    ASSERT_TRUE(ready());
    find<QComboBox>("person")->setEditText(QString(3, QLatin1Char('\t')) + QStringLiteral("a\tb"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !find<QPushButton>("set-sail")->isEnabled(); }, 10'000));
    EXPECT_FALSE(find<QLabel>("person-note")->text().isEmpty());
}

TEST_F(Practise, PicturesInDayAndNight) {
    if (qEnvironmentVariableIsEmpty("SAGARA_UI_PICTURES")) GTEST_SKIP() << "nobody looks";
    for (const QSize size : {QSize(1280, 680), QSize(1920, 1040)})
        for (const auto& [palette, name] :
             {std::pair{ui::PaletteName::Day, "day"}, {ui::PaletteName::Night, "night"}}) {
            setColours(palette);
            window().resize(size);
            open();
            ASSERT_TRUE(ready());
            const auto keep = [&](const char* what) {
                keepPicture(QStringLiteral("practise-%1-%2-%3.png")
                                .arg(QLatin1String(what), QLatin1String(name))
                                .arg(size.width()));
            };
            find<QCheckBox>("own-weather")->setChecked(true);
            keep("lesson");
            find<QTabWidget>("what")->setCurrentIndex(1);
            ASSERT_TRUE(
                QTest::qWaitFor([&] { return find<QComboBox>("place", m_page)->count() > 3; }, 30'000));
            keep("free");
            ui::SailResult result;
            result.name = QStringLiteral("Basic Navigation");
            result.graded = true;
            result.score = 76.0;
            result.passed = true;
            result.sailed_s = 2105.0;
            result.tasks = {{QStringLiteral("Single up and spring off"), true, 95.0},
                            {QStringLiteral("Pass the entrance"), true, 610.0},
                            {QStringLiteral("Anchor and bring up"), false, 0.0}};
            result.losses = {{401.0, QStringLiteral("Keep to the speeds"),
                              QStringLiteral("speed over ground 7.4 kn, limit 6.0 kn"), 4.0, false},
                             {1502.0, QStringLiteral("Pass other ships well clear outside"),
                              QStringLiteral("passing distance 380.0 m, limit 463.0 m"), 5.0, false}};
            result.recording = "x";
            result.best = QStringLiteral("Your best here: 88 of 100");
            frame().openPage(new ui::SailResultPage(result, {}));
            keep("result");
            frame().dropPages();
        }
}

}  // namespace
}  // namespace sagara::station

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
