// The doors to the trainee's console: a page of the window, and a window of its own.
#include "app/station/ConsoleDoor.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <QApplication>
#include <QPointer>
#include <QTest>
#include <QTextBrowser>

#include "app/files/BuildScenario.h"
#include "app/station/StationRun.h"
#include "tests/app/station/NoWindow.h"
#include "ui/trainee/ConsolePage.h"

namespace sagara::station {
namespace {

namespace fs = std::filesystem;

class DoorToTheConsole : public ::testing::Test {
protected:
    void SetUp() override {
        m_folder = fs::temp_directory_path() / ("sagara-console-" + std::to_string(::getpid()));
        fs::remove_all(m_folder);
        auto store = run::Store::open(m_folder);
        ASSERT_TRUE(store) << store.error();
        m_store = std::move(store).value();
        RunRequest request;
        request.scenario = "basic-navigation";
        auto run = StationRun::open(*m_store, request);
        ASSERT_TRUE(run) << run.error();
        m_run = std::move(run).value();
    }
    void TearDown() override {
        m_run.reset();
        m_store.reset();
        fs::remove_all(m_folder);
    }
    fs::path m_folder;
    std::unique_ptr<run::Store> m_store;
    std::unique_ptr<StationRun> m_run;
};

TEST_F(DoorToTheConsole, GivesAPageThatSteersTheRunningShip) {
    NoWindow frame(*m_store, ui::PaletteName::Night);
    ui::ConsoleOptions options;
    options.startsRun = true;
    const std::unique_ptr<ui::ConsolePage> page(consolePage(frame, *m_run, options));
    page->resize(1280, 720);
    page->show();
    page->console().takeWatch();
    ASSERT_TRUE(m_run->running());
    page->console().setHelm(0.2);
    ASSERT_TRUE(QTest::qWaitFor([&] { return m_run->latest()->ships[0].rudder_rad > 0.05; }, 20'000));
    m_run->freeze();
    EXPECT_TRUE(page->mayLeave());
}

TEST_F(DoorToTheConsole, GivesAWindowWithHelpThatClosesItself) {
    NoWindow frame(*m_store, ui::PaletteName::Night);
    QPointer<ui::TraineeConsole> console = consoleWindow(frame, *m_run, {});
    ASSERT_TRUE(console != nullptr);
    EXPECT_TRUE(console->isVisible());
    EXPECT_TRUE(console->isWindow());
    console->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(console.data(), 5000));
    QTest::keyClick(console.data(), Qt::Key_F1);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return console->findChild<QTextBrowser*>(QStringLiteral("help-page")) != nullptr; }, 5000));
    const auto* const help = console->findChild<QTextBrowser*>(QStringLiteral("help-page"));
    EXPECT_TRUE(help->toPlainText().contains(QStringLiteral("Take the watch")));
    console->close();
    ASSERT_TRUE(QTest::qWaitFor([&] { return console == nullptr; }, 5000));
}

}  // namespace
}  // namespace sagara::station

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
