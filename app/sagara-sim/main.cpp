// sagara-sim: Sagara without a screen. Options here, work in app/run and app/tools.
#include <QGuiApplication>

#include "Commands.h"
#include "app/run/RunOptions.h"

int main(int argc, char** argv) {
    using namespace sagara::sim;
    CLI::App app("Sagara without a screen: run, replay and grade exercises; try and validate ships");
    app.name("sagara-sim");
    app.require_subcommand(1);
    Commands commands(app);
    for (const auto add : {
             addRun,
             addReplay,
             addWall,
             addValidateDocument,
             addList,
             addBackup,
             addManoeuvre,
             addDecay,
             addForces,
             addPilotCard,
             addValidate,
             addSea,
             addWindLoad,
             addSquat,
             addRao,
             addHydrostatics,
             addIdentify,
         }) {
        add(commands);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? sagara::run::kDone : sagara::run::kBadRequest;
    }
    // Fonts and PDF need a QGuiApplication; the offscreen platform needs no display.
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication qt(argc, argv);
    return commands.carryOut();
}
