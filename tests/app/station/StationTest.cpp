// The station driven as a trainer would, without a display: start page, desk, a run, its result.
#include "app/station/Station.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QTableView>
#include <QTest>
#include <cstdlib>
#include <fstream>

#include "app/files/BuildScenario.h"
#include "app/files/Files.h"
#include "app/station/DeskPage.h"
#include "core/exercise/Replay.h"
#include "core/exercise/Session.h"
#include "db/RunRepository.h"
#include "ui/debrief/DebriefPage.h"
#include "ui/start/StartPage.h"
#include "ui/trainer/RunBar.h"
#include "ui/trainer/TrainerDesk.h"

namespace sagara::station {
namespace {

namespace fs = std::filesystem;

class StationWindow : public ::testing::Test {
protected:
    void SetUp() override {
        m_folder = fs::temp_directory_path() / ("sagara-station-" + std::to_string(::getpid()));
        fs::remove_all(m_folder);
        auto store = run::Store::open(m_folder);
        ASSERT_TRUE(store) << store.error();
        m_store = std::move(store).value();
        m_station = std::make_unique<Station>(*m_store,
                                              render::StageOptions{SAGARA_ASSETS, render::Preset::Low, true});
        m_station->resize(1280, 720);
        m_station->show();
    }
    void TearDown() override {
        m_station.reset();
        m_store.reset();
        fs::remove_all(m_folder);
    }

    template <typename Widget>
    Widget* find(const char* name) {
        auto* const widget = m_station->findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(widget, nullptr) << name;
        return widget;
    }
    void openLessons() { QTest::mouseClick(find<QPushButton>("door-lesson"), Qt::LeftButton); }
    void openDesk(int row = 0) {
        openLessons();
        find<QListWidget>("scenarios")->setCurrentRow(row);
        QTest::mouseClick(find<QPushButton>("open"), Qt::LeftButton);
        // it is built aside, and shown in a breath of its own
        ASSERT_TRUE(QTest::qWaitFor([&] { return page() != nullptr && desk()->isVisible(); }, 30'000));
    }
    /// A run of the pilot at twenty times the pace, so far.
    void sail(double until_s) {
        RunRequest request;
        request.scenario = "basic-navigation";
        request.trainee = "Nimal Perera";
        request.pilot = true;
        ASSERT_FALSE(m_station->openRun(request));
        run().setRate(20.0);
        run().start();
        ASSERT_TRUE(QTest::qWaitFor([&] { return run().latest()->time().seconds() > until_s; }, 60'000));
    }
    void startAgain() {
        m_station.reset();
        m_store.reset();
        auto store = run::Store::open(m_folder);
        ASSERT_TRUE(store) << store.error();
        m_store = std::move(store).value();
        m_station = std::make_unique<Station>(*m_store,
                                              render::StageOptions{SAGARA_ASSETS, render::Preset::Low, true});
        m_station->resize(1280, 720);
        m_station->show();
    }
    int noticesThatSay(const QString& text) {
        int found = 0;
        for (const QLabel* said : m_station->findChildren<QLabel*>(QStringLiteral("notice-text")))
            found += said->text().contains(text) ? 1 : 0;
        return found;
    }
    /// Ended though the database is away, told on the page of its result; filed, once, by the next start.
    void expectKeptAndFiledLater(const std::function<void()>& comesBack) {
        ASSERT_TRUE(run().running());
        const double then_s = run().latest()->time().seconds();
        ASSERT_TRUE(QTest::qWaitFor([&] { return run().latest()->time().seconds() > then_s + 5.0; }, 60'000));
        run().freeze();
        QTest::qWait(200);
        const auto hash = core::stateHash(run().state());
        const fs::path name = run().recording().filename();
        page()->endRun();
        ASSERT_EQ(page(), nullptr);
        bool told = false;
        for (const QLabel* label : m_station->page()->findChildren<QLabel*>())
            told = told || label->text().contains(QStringLiteral("filed at a later start"));
        EXPECT_TRUE(told);
        keepPicture("database-gone.png");
        for (const char* door : {"door-roster", "door-debrief", "door-lesson", "door-practise"}) {
            ASSERT_TRUE(m_station->leaveAll());
            QTest::mouseClick(find<QPushButton>(door), Qt::LeftButton);  // says so, and stands
            QApplication::processEvents();
        }
        comesBack();
        startAgain();
        EXPECT_EQ(noticesThatSay(QStringLiteral("Filed the earlier run")), 1);
        const auto runs = db::RunRepository(*m_store->database()).list();
        ASSERT_EQ(runs.size(), 1u);
        EXPECT_EQ(runs[0].status, db::RunStatus::Aborted);
        EXPECT_EQ(m_store->folder().pathOf(runs[0].start.recordingFile).filename(), name);
        EXPECT_EQ(runs[0].stateHash, hash);
        startAgain();
        EXPECT_EQ(noticesThatSay(QStringLiteral("earlier run")), 0);
    }
    DeskPage* page() { return dynamic_cast<DeskPage*>(m_station->page()); }
    StationRun& run() { return page()->run(); }
    ui::TrainerDesk* desk() { return page()->desk(); }
    bool logSays(const QString& text) {
        auto* const log = find<QListWidget>("log");
        for (int i = 0; i < log->count(); ++i)
            if (log->item(i)->text().contains(text)) return true;
        return false;
    }
    void keepPicture(const char* name) {
        QApplication::processEvents();  // what was raised is laid out
        if (const char* folder = std::getenv("SAGARA_UI_PICTURES"))
            m_station->grab().save(QString::fromUtf8(folder) + QLatin1Char('/') + QString::fromLatin1(name));
    }

    fs::path m_folder;
    std::unique_ptr<run::Store> m_store;
    std::unique_ptr<Station> m_station;
};

TEST_F(StationWindow, ListsTheShippedScenariosWithTheirBriefing) {
    keepPicture("home.png");
    openLessons();
    auto* const list = find<QListWidget>("scenarios");
    ASSERT_GE(list->count(), 2);
    EXPECT_EQ(list->item(0)->text(), QStringLiteral("Basic Navigation"));
    EXPECT_TRUE(find<QPushButton>("open")->isEnabled());
    keepPicture("lesson.png");
}

TEST_F(StationWindow, ARunIsStartedFrozenHastenedAndEnded) {
    openDesk();
    auto* const start = find<QPushButton>("start");
    EXPECT_EQ(start->text(), QStringLiteral("Start"));
    EXPECT_EQ(run().latest()->tick, 0);
    QTest::mouseClick(start, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().latest()->tick > 10; }, 10'000));
    auto* const rate = find<QComboBox>("rate");
    rate->setCurrentIndex(rate->findData(20));
    EXPECT_EQ(run().rate(), 20.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().latest()->time().seconds() > 5.0; }, 10'000));
    desk()->refresh();
    EXPECT_EQ(start->text(), QStringLiteral("Freeze"));
    keepPicture("desk.png");
    QTest::mouseClick(start, Qt::LeftButton);
    EXPECT_FALSE(run().running());

    const fs::path recording = run().recording();
    page()->endRun();
    const auto bytes = files::readBinaryFile(recording);
    ASSERT_TRUE(bytes) << bytes.error().message;
    const auto read = core::readRecording(*bytes);
    ASSERT_TRUE(read) << read.error();
    EXPECT_TRUE(read->damage.empty()) << read->damage;
    EXPECT_TRUE(read->end.has_value());
    EXPECT_EQ(db::RunRepository(*m_store->database()).list().size(), 1u);
}

TEST_F(StationWindow, OrdersEventsFaultsAndWeatherReachTheRun) {
    openDesk();
    QTest::mouseClick(find<QPushButton>("start"), Qt::LeftButton);
    find<QSlider>("rudder")->setValue(20);
    QTest::mouseClick(find<QPushButton>("event-rain-squall"), Qt::LeftButton);
    EXPECT_FALSE(find<QPushButton>("event-rain-squall")->isEnabled());
    find<QCheckBox>("fault-jam")->setChecked(true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().latest()->ships[0].rudderOrder_rad > 0.3; }, 10'000));
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return (desk()->refresh(), logSays(QStringLiteral("rain squall"))); }, 10'000));
    ASSERT_TRUE(QTest::qWaitFor([&] { return (desk()->refresh(), logSays(QStringLiteral("rudder jammed"))); },
                                10'000));
    QTest::mouseClick(find<QPushButton>("apply-weather"), Qt::LeftButton);
    desk()->showPanel(QStringLiteral("events"));
    keepPicture("desk-events.png");
    auto* const difficulty = find<QComboBox>("difficulty");
    difficulty->setCurrentIndex(4);
    Q_EMIT difficulty->activated(4);
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().latest()->level == 5; }, 10'000));
}

TEST_F(StationWindow, ThePilotSailsTheLessonFromTheDesk) {
    RunRequest request;
    request.scenario = "basic-navigation";
    request.pilot = true;
    ASSERT_FALSE(m_station->openRun(request));
    run().setRate(20.0);
    run().start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().latest()->tasks[0].done; }, 60'000));
    desk()->refresh();
    EXPECT_TRUE(find<QListWidget>("tasks")->item(0)->text().startsWith(QStringLiteral("✓")));
    keepPicture("desk-under-way.png");
}

TEST_F(StationWindow, GoesBackAndKeepsWhatWasSailed) {
    RunRequest request;
    request.scenario = "basic-navigation";
    request.pilot = true;
    ASSERT_FALSE(m_station->openRun(request));
    run().setRate(20.0);
    run().start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().latest()->time().seconds() > 40.0; }, 60'000));
    const fs::path first = run().recording();
    Q_EMIT desk()->goBackWanted(15);
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().recording() != first; }, 10'000));
    EXPECT_EQ(run().latest()->tick, 15 * core::kTicksPerSecond);
    EXPECT_FALSE(run().running());
    EXPECT_EQ(run().rate(), 20.0);
    const auto state = run().state();
    const auto before = core::readRecording(*files::readBinaryFile(first));
    ASSERT_TRUE(before);
    EXPECT_TRUE(before->end.has_value());
    EXPECT_GE(before->endTick, 40 * core::kTicksPerSecond);
    const auto then = core::stateAt(*run().world(), *before, 15 * core::kTicksPerSecond);
    ASSERT_TRUE(then);
    EXPECT_EQ(core::stateHash(state), core::stateHash(*then));

    run().start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().latest()->time().seconds() > 25.0; }, 60'000));
    const fs::path second = run().recording();
    page()->endRun();
    const auto after = core::readRecording(*files::readBinaryFile(second));
    ASSERT_TRUE(after) << after.error();
    EXPECT_TRUE(after->damage.empty()) << after->damage;
    const auto world = core::worldOf(*after);
    ASSERT_TRUE(world);
    const auto replayed = core::replay(**world, *after, after->endTick, [](auto&&...) {});
    EXPECT_TRUE(replayed) << replayed.error();
    EXPECT_EQ(db::RunRepository(*m_store->database()).list().size(), 2u);
}

TEST_F(StationWindow, GoesBackToTheVeryStart) {
    RunRequest request;
    request.scenario = "basic-navigation";
    ASSERT_FALSE(m_station->openRun(request));
    const auto first = core::stateHash(run().state());
    run().give(0, core::HelmOrder{0.2});
    run().start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().latest()->time().seconds() > 1.2; }, 60'000));
    const auto way = run().wayBack(0);
    ASSERT_TRUE(way) << way.error();
    auto there = way.value()();
    ASSERT_TRUE(there) << there.error();
    ASSERT_EQ(run().goBack(std::move(there).value()).value_or(""), "");
    EXPECT_EQ(core::stateHash(run().state()), first);
    EXPECT_TRUE(run().eventsFrom(0).empty());
    run().start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().latest()->time().seconds() > 2.2; }, 60'000));
    const fs::path second = run().recording();
    (void)run().end();
    const auto after = core::readRecording(*files::readBinaryFile(second));
    ASSERT_TRUE(after) << after.error();
    const auto replayed = core::replay(*run().world(), *after, after->endTick, [](auto&&...) {});
    EXPECT_TRUE(replayed) << replayed.error();
}

TEST_F(StationWindow, GoingBackIsCalledOffOrLeftAlone) {
    sail(20.0);
    const fs::path first = run().recording();
    Q_EMIT desk()->goBackWanted(15);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !desk()->isEnabled(); }, 10'000));
    keepPicture("going-back.png");
    QTest::mouseClick(find<QPushButton>("stay"), Qt::LeftButton);
    EXPECT_TRUE(desk()->isEnabled());
    QTest::qWait(1000);
    EXPECT_EQ(run().recording(), first);
    EXPECT_FALSE(run().running());
    run().start();
    EXPECT_TRUE(run().running());

    Q_EMIT desk()->goBackWanted(5);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !desk()->isEnabled(); }, 10'000));
    page()->endRun();  // while it is worked out
    ASSERT_TRUE(QTest::qWaitFor([&] { return page() == nullptr; }, 10'000));
    QTest::qWait(1000);
    EXPECT_EQ(db::RunRepository(*m_store->database()).list().size(), 1u);
}

TEST_F(StationWindow, WhoOpensALessonBeforeItIsBuiltWaitsForIt) {
    openLessons();
    auto* const list = find<QListWidget>("scenarios");
    for (int row = 0; row < list->count(); ++row) list->setCurrentRow(row);
    list->setCurrentRow(0);
    QTest::mouseClick(find<QPushButton>("open"), Qt::LeftButton);
    EXPECT_EQ(page(), nullptr);  // the page with its list stays, and answers
    ASSERT_TRUE(QTest::qWaitFor([&] { return page() != nullptr; }, 30'000));
    EXPECT_EQ(run().world()->scenarioName, "Basic Navigation");
    page()->endRun();
    ASSERT_TRUE(m_station->leaveAll());

    openLessons();
    find<QListWidget>("scenarios")->setCurrentRow(1);
    QTest::mouseClick(find<QPushButton>("open"), Qt::LeftButton);
    ASSERT_TRUE(m_station->leaveAll());  // while it is built
    QTest::qWait(1000);
    EXPECT_EQ(m_station->depth(), 1u);
}

TEST_F(StationWindow, ARunOutlivesItsDatabaseAndIsFiledByTheNextStart) {
    sail(5.0);
    for (const char* end : {"", "-wal", "-shm"}) fs::remove(m_store->folder().database().string() + end);
    expectKeptAndFiledLater([] {});
}

TEST_F(StationWindow, ARunOutlivesItsWholeFolderAndIsFiledByTheNextStart) {
    sail(5.0);
    const fs::path away = m_folder.string() + "-away";
    fs::remove_all(away);
    fs::rename(m_folder, away);
    expectKeptAndFiledLater([&] {
        fs::remove_all(m_folder);
        fs::rename(away, m_folder);
    });
}

TEST_F(StationWindow, WidthsAndSortingOfTablesAreKept) {
    const auto table = [this] {
        QTest::mouseClick(find<QPushButton>("door-roster"), Qt::LeftButton);
        QTest::qWait(100);
        auto* const view = m_station->page()->findChild<QTableView*>();
        EXPECT_NE(view, nullptr);
        return view;
    };
    auto* const before = table()->horizontalHeader();
    before->resizeSection(1, 137);
    before->setSortIndicator(1, Qt::DescendingOrder);
    ASSERT_TRUE(m_station->leaveAll());
    startAgain();
    auto* const after = table()->horizontalHeader();
    EXPECT_EQ(after->sectionSize(1), 137);
    EXPECT_EQ(after->sortIndicatorSection(), 1);
    EXPECT_EQ(after->sortIndicatorOrder(), Qt::DescendingOrder);
}

TEST_F(StationWindow, TheChoiceOfPlotsIsKept) {
    sail(5.0);
    const fs::path recording = run().recording();
    page()->endRun();
    const auto debriefing = [&]() -> ui::DebriefDesk* {
        EXPECT_FALSE(m_station->openDebrief(recording));
        auto* const shown = dynamic_cast<ui::DebriefPage*>(m_station->page());
        EXPECT_TRUE(QTest::qWaitFor([&] { return shown->desk() != nullptr; }, 30'000));
        QTest::qWait(200);
        return shown->desk();
    };
    ui::DebriefDesk* desk = debriefing();
    for (int i = 0; i < 3; ++i) desk->findChild<QAction*>(QStringLiteral("plot-%1").arg(i))->trigger();
    const QString chosen = desk->plotsShown();
    ASSERT_TRUE(m_station->leavePage());
    desk = debriefing();
    EXPECT_EQ(desk->plotsShown(), chosen);
    ASSERT_TRUE(m_station->leavePage());
    EXPECT_FALSE(m_station->openDebrief(recording));
    ASSERT_TRUE(m_station->leavePage());  // before it is open
    QTest::qWait(1000);
}

TEST_F(StationWindow, AnAssessmentDoesNotGoBack) {
    RunRequest request;
    request.scenario = "basic-navigation";
    request.type = "assess";
    ASSERT_FALSE(m_station->openRun(request));
    EXPECT_FALSE(find<QPushButton>("go-back")->isEnabled());
    EXPECT_FALSE(run().wayBack(0));
}

TEST_F(StationWindow, ARunThatWasBrokenOffIsTakenUp) {
    RunRequest request;
    request.scenario = "basic-navigation";
    request.pilot = true;
    ASSERT_FALSE(m_station->openRun(request));
    run().setRate(20.0);
    run().start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().latest()->time().seconds() > 12.0; }, 60'000));
    const auto bytes = files::readBinaryFile(run().recording());  // as a killed program leaves it
    ASSERT_TRUE(bytes);
    const fs::path broken = m_store->folder().recordings() / "broken.sgr";
    std::ofstream(broken, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
    auto taken = StationRun::takeUp(*m_store, broken);
    ASSERT_TRUE(taken) << taken.error();
    EXPECT_GE((*taken)->latest()->time().seconds(), 10.0);
    EXPECT_FALSE((*taken)->running());
    EXPECT_FALSE((*taken)->sailedBefore().empty());
}

TEST_F(StationWindow, TheNextStartOffersToResume) {
    const std::string name = "recordings/killed.sgr";
    {
        auto world = files::buildScenario(*m_store, "basic-navigation");
        ASSERT_TRUE(world);
        const fs::path path = m_store->folder().pathOf(name);
        run::RunFiling filing(*m_store);
        const auto header = run::newHeader(**world, 3, "train", "Nimal Perera");
        std::string trouble;
        auto file = run::RecordingFile::open(path, 0, trouble);
        ASSERT_TRUE(file) << trouble;
        core::RecordingWriter writer([&](std::span<const std::byte> bytes) { file->write(bytes); });
        core::State start = core::startState(**world, 3);
        writer.begin(header, **world, start);
        ASSERT_EQ(filing.begin(filing.newRun(header, **world, path)), "");
        core::Session session(*world, std::move(start), {}, &writer);
        for (int i = 0; i < 12 * core::kTicksPerSecond + 7; ++i) (void)session.step();
    }  // killed: no end
    Station next(*m_store, render::StageOptions{SAGARA_ASSETS, render::Preset::Low, true});
    next.show();
    QApplication::processEvents();
    auto* const text = next.findChild<QLabel*>(QStringLiteral("notice-text"));
    ASSERT_NE(text, nullptr);
    EXPECT_TRUE(text->text().contains(QStringLiteral("Nimal Perera")) &&
                text->text().contains(QStringLiteral(" 00:12")))
        << text->text().toStdString();
    if (const char* folder = std::getenv("SAGARA_UI_PICTURES"))
        next.grab().save(QString::fromUtf8(folder) + QStringLiteral("/resume.png"));
    QTest::mouseClick(next.findChild<QPushButton*>(QStringLiteral("resume")), Qt::LeftButton);
    auto* const desk = dynamic_cast<DeskPage*>(next.page());
    ASSERT_NE(desk, nullptr);
    EXPECT_EQ(desk->run().latest()->tick, 12 * core::kTicksPerSecond);
    EXPECT_EQ(desk->run().header().trainee, "Nimal Perera");
}

TEST_F(StationWindow, TheWallIsStartedAndStoppedFromTheDesk) {
    openDesk();
    auto* const layout = find<QComboBox>("wall-layout");
    layout->setCurrentIndex(layout->findData(QStringLiteral("single")));
    find<QComboBox>("wall-placement")->setCurrentIndex(2);
    QTest::mouseClick(find<QPushButton>("wall-start"), Qt::LeftButton);
    EXPECT_FALSE(layout->isEnabled());
    StationWall& wall = page()->wall();
    const auto inStep = [&] {
        const auto status = wall.status();
        return status.channels.size() == 1 && status.channels[0].state == "in step" &&
               status.channels[0].rate_Hz > 0.0;
    };
    ASSERT_TRUE(QTest::qWaitFor(inStep, 60'000)) << wall.status().trouble;
    desk()->showPanel(QStringLiteral("wall"));
    keepPicture("desk-wall.png");
    QTest::mouseClick(find<QPushButton>("wall-start"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !wall.status().running; }, 10'000));
    ASSERT_TRUE(QTest::qWaitFor([&] { return layout->isEnabled(); }, 5'000));
}

TEST_F(StationWindow, AShipThatIsAddedIsSeenInTheViews) {
    openDesk();
    const core::ShipMotion own = run().latest()->ships[0].motion;
    core::AddTargetOrder order;
    order.name = "Sea Star";
    order.type = core::TargetType::Ferry;
    order.position = own.position() + 130.0 * core::unitVector(own.heading_rad + 0.25);
    order.heading_rad = own.heading_rad + 1.5;
    order.speed_mps = 2.0;
    order.length_m = 60.0;
    order.beam_m = 12.0;
    order.draught_m = 3.0;
    run().give(0, order);
    run().start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().latest()->added.size() == 1; }, 10'000));
    QTest::qWait(1500);  // some pictures
    desk()->refresh();
    EXPECT_TRUE(logSays(QStringLiteral("Sea Star appears")));
    keepPicture("desk-added-ship.png");
}

TEST_F(StationWindow, AfterTheEndNothingCanBeOrdered) {
    openDesk();
    run().give(0, core::FinishOrder{});
    QTest::mouseClick(find<QPushButton>("start"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return run().over(); }, 10'000));
    desk()->refresh();
    EXPECT_FALSE(find<QPushButton>("start")->isEnabled());
    EXPECT_FALSE(find<QSlider>("rudder")->isEnabled());
    EXPECT_FALSE(find<QPushButton>("apply-weather")->isEnabled());
    EXPECT_TRUE(find<QPushButton>("end")->isEnabled());
}

TEST_F(StationWindow, AScenarioThatIsNotThereIsAMessage) {
    RunRequest request;
    request.scenario = "nowhere";
    const auto trouble = m_station->openRun(request);
    ASSERT_TRUE(trouble);
    EXPECT_NE(trouble->find("nowhere"), std::string::npos);
    EXPECT_EQ(page(), nullptr);
}

}  // namespace
}  // namespace sagara::station

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
