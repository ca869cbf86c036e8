#include "app/station/Doors.h"

#include <QCoreApplication>

#include "app/files/BuildScenario.h"
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
    if (!station.store().trouble().empty())
        home->addNotice(QString::fromStdString(station.store().trouble()));
    return home;
}

ui::Page* settingsPageOf(Station& station) { return homePage(station); }
void showAbout(Station&, QWidget*) {}
QWidget* traineeWindow(Frame&, StationRun&) { return nullptr; }
void showResult(Frame& frame, StationRun&, const run::RunSummary&) {
    frame.replacePage(lessonPage(frame));
}

}  // namespace sagara::station
