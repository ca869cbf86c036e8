// The exhibition: pilot, visitor, reset, and what it must survive. Fast timing; a picture only where it is
// looked at.
#include <gtest/gtest.h>
#include <unistd.h>

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "FakeFrame.h"
#include "app/files/BuildScenario.h"
#include "app/station/DemoDoor.h"
#include "app/station/DemoRun.h"
#include "db/PersonRepository.h"
#include "db/RunRepository.h"
#include "db/SettingRepository.h"
#include "ui/demo/DemoPage.h"

namespace sagara::station {
namespace {

using Phase = ui::DemoDirector::Phase;

class Demo : public FakeStation {
protected:
    /// Beats are the test's: the timings below are in its seconds.
    ui::DemoPage* open(DemoOptions options = {}) {
        options.fullScreen = false;
        auto page = openDemo(frame(), std::move(options));
        EXPECT_TRUE(page) << page.error();
        auto* const demo = static_cast<ui::DemoPage*>(*page);
        frame().openPage(demo);
        return demo;
    }
    static void pass(ui::DemoPage& page, double seconds) {
        for (double t = 0.0; t < seconds; t += 0.5) page.beat(0.5);
    }
    static void key(ui::DemoPage& page, Qt::Key key, Qt::KeyboardModifiers with = {}) {
        QTest::keyClick(&page, key, with);
    }
    static bool sailed(ui::DemoPage& page, std::int64_t ticks) {
        return QTest::qWaitFor([&] { return page.run().latest()->tick >= ticks; }, 20'000);
    }
};

TEST_F(Demo, ThePilotSailsAndTheCamerasChange) {
    auto* const page = open();
    ASSERT_TRUE(sailed(*page, 20));
    EXPECT_TRUE(page->run().latest()->ships[0].pilotEngaged);
    const ui::DemoCamera first = page->camera();
    pass(*page, 12.5);
    EXPECT_FALSE(page->camera() == first);
    EXPECT_EQ(page->director().phase(), Phase::Attract);
    EXPECT_TRUE(page->findChild<ui::DemoOverlay*>()->shown().invites);
}

TEST_F(Demo, AKeyTakesTheHelmOfAShipUnderWayAndSteersHer) {
    auto* const page = open();
    ASSERT_TRUE(sailed(*page, 5));
    key(*page, Qt::Key_A);
    EXPECT_EQ(page->director().phase(), Phase::Helm);
    EXPECT_EQ(page->run().world()->scenarioId, "heavy-weather") << "she was made fast";
    EXPECT_EQ(page->camera().kind, ui::DemoCameraKind::Bridge);
    key(*page, Qt::Key_Right);
    key(*page, Qt::Key_Right);
    key(*page, Qt::Key_PageUp);
    QTest::mouseClick(page->findChild<QPushButton*>(QStringLiteral("demo-starboard")), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            const auto now = page->run().latest();
            return !now->ships[0].pilotEngaged && now->ships[0].rudderOrder_rad > 0.25;
        },
        10'000));
    const auto& shown = page->findChild<ui::DemoOverlay*>()->shown();
    ASSERT_TRUE(shown.guide);
    EXPECT_EQ(shown.guide->rudder.toStdString(), "Starboard 15°");
}

TEST_F(Demo, AfterThreeMinutesThereIsAScoreAndThenAllBeginsAgain) {
    auto* const page = open();
    key(*page, Qt::Key_A);
    for (int i = 0; i < 4; ++i) {
        pass(*page, 44.0);
        key(*page, Qt::Key_Left);
    }
    pass(*page, 5.0);
    EXPECT_EQ(page->director().phase(), Phase::Score);
    const auto& verdict = page->findChild<ui::DemoOverlay*>()->shown().verdict;
    ASSERT_TRUE(verdict);
    EXPECT_GE(verdict->stars, 1);
    EXPECT_FALSE(verdict->sentence.isEmpty());
    pass(*page, 20.5);
    EXPECT_EQ(page->director().phase(), Phase::Attract);
    EXPECT_EQ(page->figures().resets, 1u);
}

/// What is promised: whatever a visitor did, the first State is the same to the byte.
TEST_F(Demo, EveryResetIsTheSameFirstStateToTheByteAndTakesNoMemory) {
    DemoOptions options;
    options.scenarios = {"heavy-weather"};
    auto* const page = open(options);
    const core::Bytes first = core::toBytes(core::startState(*page->run().world(), options.level));
    const std::uint64_t hash = core::stateHash(core::startState(*page->run().world(), options.level));
    int compared = 0;
    QObject::connect(page, &ui::DemoPage::atFirstState, page, [&] {
        const core::State state = page->run().state();
        EXPECT_EQ(core::stateHash(state), hash);
        EXPECT_TRUE(core::toBytes(state) == first);
        ++compared;
    });
    std::int64_t settled_kB = 0;
    constexpr int kResets = 22, kSettledAfter = 2;
    for (int i = 0; i < kResets; ++i) {
        if (i == kSettledAfter) settled_kB = ui::residentMemory_kB();
        key(*page, Qt::Key_Space);
        page->run().setRate(20.0);
        key(*page, i % 2 == 0 ? Qt::Key_Left : Qt::Key_Right);
        key(*page, Qt::Key_PageUp);
        ASSERT_TRUE(sailed(*page, 100 + 10 * i));
        pass(*page, 60.5);  // nobody touches anything any more
        ASSERT_EQ(page->figures().resets, static_cast<std::uint64_t>(i + 1));
    }
    EXPECT_EQ(compared, kResets);
    EXPECT_EQ(page->figures().unequal, 0u);
    const std::int64_t growth_kB = ui::residentMemory_kB() - settled_kB;
    EXPECT_LE(growth_kB, 5 * 1024) << "over " << kResets - kSettledAfter << " resets";
    RecordProperty("growth_kB", static_cast<int>(growth_kB));
    std::printf("growth over %d resets: %lld kB\n", kResets - kSettledAfter,
                static_cast<long long>(growth_kB));
}

TEST_F(Demo, NothingIsWrittenToRosterRunsOrRecordings) {
    auto* const page = open();
    key(*page, Qt::Key_A);
    ASSERT_TRUE(sailed(*page, 50));
    pass(*page, 61.0);
    page->run().give(0, core::FinishOrder{});
    // The page's own beat may have gone on to the next lesson already.
    ASSERT_TRUE(QTest::qWaitFor([&] { return page->run().over() || page->lesson() == 0; }, 10'000));
    pass(*page, 1.0);
    EXPECT_EQ(page->lesson(), 0u) << "after a whole lesson, the second, comes the next";
    EXPECT_EQ(db::RunRepository(*store().database()).count(), 0);
    EXPECT_TRUE(db::PersonRepository(*store().database()).inUse().empty());
    EXPECT_TRUE(std::filesystem::is_empty(store().folder().recordings()));
}

TEST_F(Demo, OnlyChordAndPinLeaveIt) {
    db::SettingRepository(*store().database()).put("demo.pin", "2580");
    auto* const page = open();
    bool left = false;
    QObject::connect(page, &ui::Page::leaveWanted, page, [&] { left = true; });
    auto* const pad = page->findChild<ui::PinPad*>();
    EXPECT_FALSE(page->mayLeave()) << "closing the window asks for the PIN";
    EXPECT_TRUE(pad->isVisible());
    QTest::keyClick(pad, Qt::Key_Escape);
    EXPECT_FALSE(pad->isVisible());
    key(*page, Qt::Key_Q, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(pad->isVisible());
    EXPECT_EQ(page->director().phase(), Phase::Attract) << "the chord is no touch";
    keepPicture("demo-pin.png");
    for (const char digit : std::string("0000")) QTest::keyClick(pad, static_cast<Qt::Key>(digit));
    EXPECT_FALSE(left);
    EXPECT_FALSE(page->findChild<QPushButton*>(QStringLiteral("pin-2"))->isEnabled()) << "a wrong PIN waits";
    pass(*page, 3.5);
    for (const char digit : std::string("2580"))
        QTest::mouseClick(page->findChild<QPushButton*>(QStringLiteral("pin-%1").arg(QLatin1Char(digit))),
                          Qt::LeftButton);
    EXPECT_TRUE(left);
    EXPECT_TRUE(page->mayLeave());
}

TEST_F(Demo, AJoystickMayComeAndGo) {
    std::optional<ui::StickReading> stick;
    DemoOptions options;
    options.stick = [&] { return stick; };
    auto* const page = open(options);
    page->beat(0.1);
    stick = ui::StickReading{0.4, 0.0, false};  // plugged in, not in the middle: that is no touch
    page->beat(0.1);
    page->beat(0.1);
    EXPECT_EQ(page->director().phase(), Phase::Attract);
    stick->rudder = -0.8;
    page->beat(0.1);
    EXPECT_EQ(page->director().phase(), Phase::Helm);
    page->beat(0.1);
    stick->rudder = 1.0;
    page->beat(0.1);
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return page->run().latest()->ships[0].rudderOrder_rad > 0.5; }, 10'000));
    stick.reset();  // pulled out
    pass(*page, 61.0);
    EXPECT_EQ(page->director().phase(), Phase::Attract);
    stick = ui::StickReading{};
    pass(*page, 1.0);
    EXPECT_EQ(page->director().phase(), Phase::Attract);
}

TEST_F(Demo, ALessonThatCannotBeReadIsLeftOut) {
    DemoOptions options;
    options.scenarios = {"nowhere", "heavy-weather"};
    auto* const page = open(options);
    EXPECT_EQ(page->run().world()->scenarioId, "heavy-weather");
    options.scenarios = {"nowhere"};
    const auto none = openDemo(frame(), options);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().find("nowhere"), std::string::npos);
    std::unique_ptr<ui::Page> told(demoPage(frame(), options));
    EXPECT_NE(told->findChild<QLabel*>(QStringLiteral("trouble")), nullptr);
}

/// Pictures to look at, with the scene: SAGARA_UI_PICTURES.
TEST_F(Demo, PicturesInDayAndNight) {
    if (qEnvironmentVariableIsEmpty("SAGARA_UI_PICTURES")) GTEST_SKIP() << "nobody looks";
    withStage();
    for (const QSize size : {QSize(1280, 720), QSize(1920, 1080)})
        for (const auto& [palette, name] :
             {std::pair{ui::PaletteName::Day, "day"}, {ui::PaletteName::Night, "night"}}) {
            setColours(palette);
            window().resize(size);
            const auto keep = [&](const char* what) {
                keepPicture(QStringLiteral("demo-%1-%2-%3.png")
                                .arg(QLatin1String(what), QLatin1String(name))
                                .arg(size.width()));
            };
            auto* const page = open();
            ASSERT_TRUE(QTest::qWaitFor([&] { return page->figures().frames > 8; }, 60'000));
            for (const char* camera : {"chase", "shore", "wing", "target", "bridge"}) {
                pass(*page, 2.0);
                QTest::qWait(2500);
                keep(camera);
                pass(*page, 10.0);
            }
            key(*page, Qt::Key_A);
            key(*page, Qt::Key_Right);
            page->beat(0.5);
            QTest::qWait(4000);
            keep("helm");
            page->run().setRate(20.0);
            for (int i = 0; i < 4; ++i) {
                pass(*page, 44.0);
                key(*page, Qt::Key_Left);
            }
            pass(*page, 5.0);
            QTest::qWait(2500);
            keep("score");
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
