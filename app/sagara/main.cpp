// sagara: the station. Options here, work in app/station and ui.
#include <CLI/CLI.hpp>
#include <QApplication>
#include <cstdio>

#include "app/files/AssetSource.h"
#include "app/station/Station.h"
#include "render/headless/HeadlessGl.h"

int main(int argc, char** argv) {
    using namespace sagara;
    std::optional<std::filesystem::path> data;
    station::RunRequest request;
    CLI::App app("Sagara's station: choose an exercise and run it from the trainer's desk");
    app.name("sagara");
    app.add_option("--data", data, "data folder (else the XDG one)");
    app.add_option("--scenario", request.scenario, "open the desk of this exercise at once: id or file");
    app.add_option("--level", request.level, "its difficulty, 1 to 5 (3)")->check(CLI::Range(1, 5));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    auto store = run::Store::open(data);
    if (!store) return std::fprintf(stderr, "sagara: %s\n", store.error().c_str()), 2;
    QApplication qt(argc, argv);
    QApplication::setApplicationName(QStringLiteral("Sagara"));
    render::StageOptions stage;
    stage.assets = files::assetFolder();
    stage.headless = !render::displayIsSet();
    station::Station window(**store, stage);
    if (!request.scenario.empty()) {
        if (const auto trouble = window.openRun(request))
            return std::fprintf(stderr, "sagara: %s\n", trouble->c_str()), 2;
    }
    window.show();
    return QApplication::exec();
}
