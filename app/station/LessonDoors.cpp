#include "app/files/BuildScenario.h"
#include "app/station/Doors.h"
#include "app/station/RosterDoor.h"
#include "app/station/SailPage.h"
#include "app/station/Station.h"
#include "db/DocumentRepository.h"
#include "db/PersonRepository.h"
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

QStringList namesOf(run::Store& store) {
    QStringList names;
    if (store.database() == nullptr) return names;
    for (const db::PersonRecord& person : db::PersonRepository(*store.database()).inUse())
        names += QString::fromStdString(person.name);
    return names;
}

core::Result<core::ExerciseDocuments, std::string> documentsOf(run::Store& store, const std::string& id) {
    try {
        return files::collectScenario(store, id);
    } catch (const db::DbError& e) {
        return std::string(e.what());
    }
}

std::optional<std::string> openWatch(Station& station, const RunRequest& request,
                                     const ui::PreparedExercise& exercise) {
    auto run = StationRun::open(station.store(), request, exercise.world);
    if (!run) return run.error();
    ui::ConsoleOptions options;
    options.startsRun = true;
    options.chart = exercise.chart;
    station.openPage(new SailPage(station, std::move(run).value(), options,
                                  [&station](StationRun& sailed, const run::RunSummary& summary) {
                                      station.replacePage(resultPage(station, sailed.recording(), summary));
                                  }));
    return std::nullopt;
}

using Open = std::optional<std::string> (*)(Station&, const RunRequest&, const ui::PreparedExercise&);

ui::Page* choicePage(Station& station, ui::StartPage::For whom, Open open) {
    run::Store& store = station.store();
    auto* const page = new ui::StartPage(whom, scenariosOf(store),
                                         [&store](const std::string& id) { return documentsOf(store, id); });
    page->setNames(namesOf(store));
    QObject::connect(page, &ui::StartPage::chosen, page,
                     [&station, page, open](const ui::StartChoice& choice) {
                         RunRequest request;
                         request.scenario = choice.scenario;
                         request.level = choice.level;
                         request.type = choice.type;
                         request.trainee = choice.trainee;
                         request.pilot = choice.pilot;
                         if (const auto trouble = open(station, request, choice.exercise))
                             page->setTrouble(QString::fromStdString(*trouble));
                     });
    return page;
}

}  // namespace

ui::Page* lessonPage(Station& station) {
    return choicePage(station, ui::StartPage::For::Trainer,
                      [](Station& s, const RunRequest& request, const ui::PreparedExercise& exercise) {
                          return s.openDesk(request, exercise);
                      });
}

ui::Page* watchPage(Station& station) { return choicePage(station, ui::StartPage::For::Trainee, openWatch); }

std::optional<std::string> enter(Station& station, const std::string& role, const RunRequest& request) {
    const bool trainee = role == "trainee";
    if (!request.scenario.empty() && trainee) {
        const auto world = files::buildScenario(station.store(), request.scenario, request.seed);
        return world ? openWatch(station, request, {*world, nullptr}) : world.error();
    }
    if (!request.scenario.empty()) return station.openRun(request);
    if (role == "trainer") station.openPage(lessonPage(station));
    if (trainee) station.openPage(watchPage(station));
    if (role == "practise") station.openPage(alonePage(station));
    if (role == "admin") station.openPage(adminPage(station));
    return std::nullopt;
}

}  // namespace sagara::station
