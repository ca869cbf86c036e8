#include "app/station/Doors.h"

#include <QCoreApplication>

#include "app/files/BuildScenario.h"
#include "app/station/BrokenOff.h"
#include "app/station/DeskPage.h"
#include "app/station/Station.h"
#include "db/DocumentRepository.h"
#include "ui/start/HomePage.h"
#include "ui/start/StartPage.h"

namespace sagara::station {
namespace {

std::vector<ui::ScenarioEntry> scenariosOf(run::Store& store) {
    std::vector<ui::ScenarioEntry> entries;
    if (store.database() != nullptr) {
        for (const auto& e : db::DocumentRepository(*store.database(), db::DocumentTable::Scenario).inUse())
            entries.push_back({e.key, e.name});
        return entries;
    }
    for (const std::string& id : store.assets().ids(core::DocumentKind::Scenario))
        entries.push_back({id, id});
    return entries;
}

ui::Page* lessonPage(Frame& frame) {
    auto* const page = new ui::StartPage(
        scenariosOf(frame.store()),
        [&store = frame.store()](const std::string& id) { return files::buildScenario(store, id); });
    QObject::connect(page, &ui::StartPage::chosen, page, [&frame, page](const ui::StartChoice& choice) {
        RunRequest request;
        request.scenario = choice.scenario;
        request.level = choice.level;
        request.type = choice.type;
        request.trainee = choice.trainee;
        request.pilot = choice.pilot;
        if (const auto trouble = frame.openRun(request)) page->setTrouble(QString::fromStdString(*trouble));
    });
    return page;
}

QString tr(const char* text);

/// Of a run that was broken off: resume it, file it as it stands, or decide at the next start.
void offerToGoOn(Station& station, ui::HomePage& home, const BrokenOff& run) {
    const auto resume = [&station, &home, run] {
        auto taken = StationRun::takeUp(station.store(), run.recording);
        if (!taken) return home.addNotice(QString::fromStdString(taken.error()));
        station.openPage(new DeskPage(station, std::move(taken).value()));
    };
    const auto file = [&station, &home, run] {
        const std::string failed = run::RunFiling(station.store()).fileAsItStands(run.recording);
        if (!failed.empty()) home.addNotice(QString::fromStdString(failed));
    };
    std::vector<ui::Room> ways;
    if (run.canGoOn)
        ways.push_back({tr("Resume"),
                        tr("Open the desk at the last saved second; the run stands still there"),
                        QStringLiteral("resume"), resume});
    ways.push_back({tr("File as it stands"),
                    tr("It is graded up to its last saved second and listed as aborted"),
                    QStringLiteral("file-broken"), file});
    ways.push_back({tr("Later"), tr("Offered again at the next start"), QStringLiteral("later"), [] {}});
    const QString who = run.trainee.empty() ? tr("nobody named") : QString::fromStdString(run.trainee);
    home.addNotice(tr("A run was broken off: %1, %2, begun %3, saved up to %4.")
                       .arg(QString::fromStdString(run.scenarioName), who,
                            QString::fromStdString(core::formatUtc(run.started)),
                            QString::fromStdString(run::clock(run.sailed_s))),
                   std::move(ways));
}

QString tr(const char* text) { return QCoreApplication::translate("Doors", text); }

}  // namespace

ui::Page* homePage(Station& station) {
    const auto open = [&station](ui::Page* (*make)(Frame&)) {
        return [&station, make] { station.openPage(make(station)); };
    };
    std::vector<ui::Door> doors;
    doors.push_back({tr("Teach"),
                     QStringLiteral("conning-iec"),
                     tr("For trainers: run a lesson from the desk, make lessons, keep the roster, debrief."),
                     {{tr("Run a lesson"), tr("Choose an exercise and open the trainer's desk"),
                       QStringLiteral("door-lesson"), open(lessonPage)}}});
    auto* const home = new ui::HomePage(std::move(doors));
    for (const std::string& message : run::RunFiling(station.store()).fileNoted())
        home->addNotice(QString::fromStdString(message));
    for (const BrokenOff& run : brokenOffRuns(station.store())) offerToGoOn(station, *home, run);
    if (!station.store().trouble().empty())
        home->addNotice(QString::fromStdString(station.store().trouble()));
    return home;
}

ui::Page* settingsPageOf(Station& station) { return homePage(station); }
void showAbout(Station&, QWidget*) {}
QWidget* traineeWindow(Frame&, StationRun&) { return nullptr; }
void showResult(Frame& frame, StationRun&, const run::RunSummary&) { frame.replacePage(lessonPage(frame)); }

}  // namespace sagara::station
