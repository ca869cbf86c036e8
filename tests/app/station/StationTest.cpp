// The station driven as a trainer would, without a display: start page, desk, a run, its result.
#include "app/station/Station.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <cstdlib>

#include "app/files/Files.h"
#include "core/exercise/Recording.h"
#include "db/RunRepository.h"
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
    void openDesk(int row = 0) {
        find<QListWidget>("scenarios")->setCurrentRow(row);
        QTest::mouseClick(find<QPushButton>("open"), Qt::LeftButton);
        ASSERT_NE(m_station->run(), nullptr);
    }
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
    auto* const list = find<QListWidget>("scenarios");
    ASSERT_GE(list->count(), 2);
    EXPECT_EQ(list->item(0)->text(), QStringLiteral("Basic Navigation"));
    EXPECT_TRUE(find<QPushButton>("open")->isEnabled());
    keepPicture("start-page.png");
}

TEST_F(StationWindow, ARunIsStartedFrozenHastenedAndEnded) {
    openDesk();
    auto* const start = find<QPushButton>("start");
    EXPECT_EQ(start->text(), QStringLiteral("Start"));
    EXPECT_EQ(m_station->run()->latest()->tick, 0);
    QTest::mouseClick(start, Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return m_station->run()->latest()->tick > 10; }, 10'000));
    auto* const rate = find<QComboBox>("rate");
    rate->setCurrentIndex(rate->findData(20));
    EXPECT_EQ(m_station->run()->rate(), 20.0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return m_station->run()->latest()->time().seconds() > 5.0; }, 10'000));
    m_station->desk()->refresh();
    EXPECT_EQ(start->text(), QStringLiteral("Freeze"));
    keepPicture("desk.png");
    QTest::mouseClick(start, Qt::LeftButton);
    EXPECT_FALSE(m_station->run()->running());

    const fs::path recording = m_station->run()->recording();
    m_station->endRun();
    EXPECT_EQ(m_station->run(), nullptr);
    auto* const result = find<QMessageBox>("result");
    EXPECT_TRUE(result->text().contains(QStringLiteral("Basic Navigation: not passed")))
        << result->text().toStdString();
    if (const char* folder = std::getenv("SAGARA_UI_PICTURES"))
        result->grab().save(QString::fromUtf8(folder) + QStringLiteral("/result.png"));
    result->close();
    const auto bytes = files::readBinaryFile(recording);
    ASSERT_TRUE(bytes) << bytes.error().message;
    const auto read = core::readRecording(*bytes);
    ASSERT_TRUE(read) << read.error();
    EXPECT_TRUE(read->damage.empty()) << read->damage;
    EXPECT_TRUE(read->end.has_value());
    EXPECT_EQ(db::RunRepository(*m_store->database()).list().size(), 1u);
    EXPECT_EQ(m_station->currentWidget(), m_station->startPage());
}

TEST_F(StationWindow, OrdersEventsFaultsAndWeatherReachTheRun) {
    openDesk();
    QTest::mouseClick(find<QPushButton>("start"), Qt::LeftButton);
    find<QSlider>("rudder")->setValue(20);
    QTest::mouseClick(find<QPushButton>("event-rain-squall"), Qt::LeftButton);
    EXPECT_FALSE(find<QPushButton>("event-rain-squall")->isEnabled());
    find<QCheckBox>("fault-jam")->setChecked(true);
    StationRun& run = *m_station->run();
    ASSERT_TRUE(QTest::qWaitFor([&] { return run.latest()->ships[0].rudderOrder_rad > 0.3; }, 10'000));
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return (m_station->desk()->refresh(), logSays(QStringLiteral("rain squall"))); }, 10'000));
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return (m_station->desk()->refresh(), logSays(QStringLiteral("rudder jammed"))); }, 10'000));
    QTest::mouseClick(find<QPushButton>("apply-weather"), Qt::LeftButton);
    m_station->desk()->showPanel(QStringLiteral("events"));
    keepPicture("desk-events.png");
    auto* const difficulty = find<QComboBox>("difficulty");
    difficulty->setCurrentIndex(4);
    Q_EMIT difficulty->activated(4);
    ASSERT_TRUE(QTest::qWaitFor([&] { return run.latest()->level == 5; }, 10'000));
}

TEST_F(StationWindow, ThePilotSailsTheLessonFromTheDesk) {
    find<QListWidget>("scenarios")->setCurrentRow(0);
    RunRequest request;
    request.scenario = "basic-navigation";
    request.pilot = true;
    ASSERT_FALSE(m_station->open(request));
    StationRun& run = *m_station->run();
    run.setRate(20.0);
    run.start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return run.latest()->tasks[0].done; }, 60'000));
    m_station->desk()->refresh();
    EXPECT_TRUE(find<QListWidget>("tasks")->item(0)->text().startsWith(QStringLiteral("✓")));
    keepPicture("desk-under-way.png");
}

TEST_F(StationWindow, AShipThatIsAddedIsSeenInTheViews) {
    openDesk();
    StationRun& run = *m_station->run();
    const core::ShipMotion own = run.latest()->ships[0].motion;
    core::AddTargetOrder order;
    order.name = "Sea Star";
    order.type = core::TargetType::Ferry;
    order.position = own.position() + 130.0 * core::unitVector(own.heading_rad + 0.25);
    order.heading_rad = own.heading_rad + 1.5;
    order.speed_mps = 2.0;
    order.length_m = 60.0;
    order.beam_m = 12.0;
    order.draught_m = 3.0;
    run.give(0, order);
    run.start();
    ASSERT_TRUE(QTest::qWaitFor([&] { return run.latest()->added.size() == 1; }, 10'000));
    QTest::qWait(1500);  // some pictures
    m_station->desk()->refresh();
    EXPECT_TRUE(logSays(QStringLiteral("Sea Star appears")));
    keepPicture("desk-added-ship.png");
}

TEST_F(StationWindow, AfterTheEndNothingCanBeOrdered) {
    openDesk();
    StationRun& run = *m_station->run();
    run.give(0, core::FinishOrder{});
    QTest::mouseClick(find<QPushButton>("start"), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return run.over(); }, 10'000));
    m_station->desk()->refresh();
    EXPECT_FALSE(find<QPushButton>("start")->isEnabled());
    EXPECT_FALSE(find<QSlider>("rudder")->isEnabled());
    EXPECT_FALSE(find<QPushButton>("apply-weather")->isEnabled());
    EXPECT_TRUE(find<QPushButton>("end")->isEnabled());
}

TEST_F(StationWindow, AScenarioThatIsNotThereIsAMessage) {
    RunRequest request;
    request.scenario = "nowhere";
    const auto trouble = m_station->open(request);
    ASSERT_TRUE(trouble);
    EXPECT_NE(trouble->find("nowhere"), std::string::npos);
    EXPECT_EQ(m_station->run(), nullptr);
}

}  // namespace
}  // namespace sagara::station

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
