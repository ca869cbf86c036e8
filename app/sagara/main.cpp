// sagara: the station. Options here, work in app/station and ui.
#include <CLI/CLI.hpp>
#include <QApplication>
#include <QScreen>
#include <cstdio>

#include "app/files/AssetSource.h"
#include "app/run/PrepareHulls.h"
#include "app/station/Doors.h"
#include "app/station/Station.h"
#include "app/station/WindowScale.h"
#include "render/headless/HeadlessGl.h"

int main(int argc, char** argv) {
    using namespace sagara;
    std::optional<std::filesystem::path> data;
    station::RunRequest request;
    std::string role = "any";
    bool demo = false;
    std::string wall;
    bool fullScreen = false;
    CLI::App app("Sagara's station: teach, train, practise, keep vessels, show a demo");
    app.name("sagara");
    app.add_option("--data", data, "data folder (else the XDG one)");
    app.add_option("--role", role, "open this door at once: trainer, trainee, practise or admin (any)")
        ->check(CLI::IsMember({"any", "trainer", "trainee", "practise", "admin"}));
    app.add_flag("--demo", demo,
                 "the exhibition: the pilot sails until somebody takes the helm; left by a chord and a PIN");
    app.add_option("--wall", wall,
                   "with --demo: a wall of that layout, each channel over a monitor (assets/walls)");
    app.add_option(
        "--scenario", request.scenario,
        "open this exercise at once, id or file: the trainer's desk, or the console of --role trainee");
    app.add_option("--level", request.level, "its difficulty, 1 to 5 (3)")->check(CLI::Range(1, 5));
    app.add_option("--trainee", request.trainee, "who sails it");
    app.add_flag("--fullscreen", fullScreen, "cover the monitor");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    auto store = run::Store::open(data);
    if (!store) return std::fprintf(stderr, "sagara: %s\n", store.error().c_str()), 2;
    station::scaleWindows(**store, render::displayIsSet(), argc, argv);
    QApplication qt(argc, argv);
    QApplication::setApplicationName(QStringLiteral("Sagara"));
    render::StageOptions stage;
    stage.assets = files::assetFolder();
    stage.preset = station::presetOfThisMachine();
    stage.ownModels = (*store)->ownModels();
    stage.headless = !render::displayIsSet();
    const run::PrepareHulls prepared(**store);
    station::Station window(**store, stage);
    const bool trainee = role == "trainee";
    if (demo || fullScreen || trainee) {
        // The first monitor is the trainer's. Geometry too: an exhibition's X server may have no window
        // manager.
        const auto screens = QGuiApplication::screens();
        window.setGeometry(screens[trainee && screens.size() > 1 ? 1 : 0]->geometry());
        window.showFullScreen();
    } else {
        window.show();
    }
    const auto trouble = demo ? station::enterDemo(window, wall) : station::enter(window, role, request);
    if (trouble) return std::fprintf(stderr, "sagara: %s\n", trouble->c_str()), 2;
    return QApplication::exec();
}
