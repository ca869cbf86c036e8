// Pictures of the console with its view, to be looked at: SAGARA_UI_PICTURES=FOLDER.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <cstdlib>

#include "SteppedRun.h"
#include "tests/support/exercise/Lesson.h"
#include "ui/theme/Theme.h"
#include "ui/trainee/TraineeConsole.h"
#include "ui/trainee/ViewPanel.h"

namespace sagara::ui {
namespace {

TEST(ConsolePictures, EveryTabByDayAndNightAtEverySize) {
    const char* const folder = std::getenv("SAGARA_UI_PICTURES");
    if (folder == nullptr) GTEST_SKIP() << "SAGARA_UI_PICTURES is not set";
    auto stage = render::Stage::open({SAGARA_ASSETS, render::Preset::Low, true});
    ASSERT_TRUE(stage) << stage.error();
    test::SteppedRun run(test::lessonWorld());
    ASSERT_FALSE((*stage)->show(run.world()));
    run.start();
    run.give(0, core::PilotOrder{true});
    run.sail(1.0);
    ConsoleOptions options;
    options.prediction = options.showRunControls = true;
    TraineeConsole console(run, stage->get(), options);
    const auto keep = [&](const QString& name) {
        for (int i = 0; i < 3; ++i) {
            console.drawFrame();
            QTest::qWait(250);
        }
        console.refresh();
        QApplication::processEvents();
        console.grab().save(QString::fromUtf8(folder) + QLatin1Char('/') + name + QStringLiteral(".png"));
    };
    auto* const tabs = console.findChild<QTabWidget*>(QStringLiteral("console-tabs"));
    auto* const deck = console.findChild<QTabWidget*>(QStringLiteral("deck"));
    console.resize(1280, 720);
    console.show();
    const auto colours = [&](PaletteName name) {
        applyTheme(*qApp, name);
        console.setColours(name);
    };
    colours(PaletteName::Day);
    keep(QStringLiteral("briefing-day"));
    console.takeWatch();
    keep(QStringLiteral("console-chart-day"));
    tabs->setCurrentIndex(2);
    keep(QStringLiteral("console-harbour-sonar-day"));
    tabs->setCurrentIndex(0);
    for (int i = 0; i < 14 * 60; i += 5) {
        run.sail(5.0);
        console.refresh();
    }
    colours(PaletteName::Day);
    run.give(0, core::FaultOrder{core::Fault::Engine, 0, false});
    run.give(0, core::FaultOrder{core::Fault::SteeringPump, 1, false});
    run.sail(1.0);
    auto* const view = console.findChild<console::ViewPanel*>();
    for (const double bearing_rad : {0.2, 1.1, -0.7}) Q_EMIT view->bearingTaken(bearing_rad);
    deck->setCurrentIndex(2);
    keep(QStringLiteral("console-alarms-day"));
    tabs->setCurrentIndex(1);
    console.findChild<QAbstractButton*>(QStringLiteral("radar-ebl"))->click();
    console.findChild<QAbstractButton*>(QStringLiteral("radar-vrm"))->click();
    console.findChild<QComboBox*>(QStringLiteral("radar-range"))->setCurrentIndex(4);
    console.findChild<QComboBox*>(QStringLiteral("radar-up"))->setCurrentIndex(1);
    colours(PaletteName::Dusk);
    keep(QStringLiteral("console-radar-dusk"));
    for (const auto& [name, word] :
         {std::pair{PaletteName::Day, "day"}, std::pair{PaletteName::Night, "night"}}) {
        colours(name);
        for (const auto& [size, px] :
             {std::pair{QSize(1280, 720), "1280"}, std::pair{QSize(1920, 1080), "1920"},
              std::pair{QSize(3840, 2160), "3840"}}) {
            console.resize(size);
            for (int tab = 0; tab < 3; ++tab) {
                if (size.width() == 3840 && tab != 1) continue;
                tabs->setCurrentIndex(tab);
                deck->setCurrentIndex(tab + 1);
                keep(QStringLiteral("console-%1-%2-%3").arg(QLatin1String(px), QLatin1String(word)).arg(tab));
            }
        }
    }
}

}  // namespace
}  // namespace sagara::ui

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    sagara::ui::applyTheme(application, sagara::ui::PaletteName::Day);
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
