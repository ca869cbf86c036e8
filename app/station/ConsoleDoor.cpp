#include "app/station/ConsoleDoor.h"

#include <QGuiApplication>
#include <QScreen>
#include <QShortcut>
#include <QWindow>

#include "app/files/AssetSource.h"
#include "ui/help/HelpWindow.h"
#include "ui/trainee/ConsolePage.h"

namespace sagara::station {
namespace {

/// A screen that no window of the station is on; null when there is only one.
QScreen* freeScreen() {
    const QWindow* const station = QGuiApplication::focusWindow();
    const QScreen* const taken = station != nullptr ? station->screen() : QGuiApplication::primaryScreen();
    for (QScreen* screen : QGuiApplication::screens())
        if (screen != taken) return screen;
    return nullptr;
}

}  // namespace

ui::ConsolePage* consolePage(Frame& frame, ui::ExerciseRun& run, ui::ConsoleOptions options) {
    options.colours = frame.colours();
    return new ui::ConsolePage(run, frame.stageFor(run.world()), options);
}

ui::TraineeConsole* consoleWindow(Frame& frame, ui::ExerciseRun& run, ui::ConsoleOptions options) {
    options.colours = frame.colours();
    auto* const console = new ui::TraineeConsole(run, frame.stageFor(run.world()), options);
    console->setAttribute(Qt::WA_DeleteOnClose);
    console->resize(1280, 720);
    const auto key = [console](const QKeySequence& keys, auto&& work) {
        QObject::connect(new QShortcut(keys, console), &QShortcut::activated, console, work);
    };
    key(Qt::Key_F11,
        [console] { console->isFullScreen() ? console->showNormal() : console->showFullScreen(); });
    key(Qt::Key_F1, [console, &frame] {
        ui::showHelp(console, files::assetFolder() / "help", QStringLiteral("console"), frame.colours());
    });
    if (QScreen* const screen = freeScreen()) {
        console->move(screen->geometry().topLeft());
        console->showFullScreen();
    } else {
        console->show();
    }
    return console;
}

}  // namespace sagara::station
