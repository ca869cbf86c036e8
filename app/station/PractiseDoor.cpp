#include "app/station/PractiseDoor.h"

#include <QDateTime>
#include <QLocale>

#include "app/station/PractiseVoyage.h"
#include "db/AssignmentRepository.h"
#include "db/DocumentRepository.h"
#include "ui/practise/PractisePage.h"

namespace sagara::station {
namespace {

using core::DocumentKind;

db::DocumentTable tableOf(DocumentKind kind) {
    if (kind == DocumentKind::Vessel) return db::DocumentTable::Vessel;
    return kind == DocumentKind::Area ? db::DocumentTable::Area : db::DocumentTable::Scenario;
}

std::vector<ui::PractiseEntry> entriesOf(run::Store& store, DocumentKind kind) {
    std::vector<ui::PractiseEntry> entries;
    if (store.database() != nullptr) {
        for (const auto& entry : db::DocumentRepository(*store.database(), tableOf(kind)).inUse())
            entries.push_back({entry.key, entry.name});
        return entries;
    }
    for (const std::string& id : store.assets().ids(kind)) entries.push_back({id, id});
    return entries;
}

std::vector<std::string> peopleOf(run::Store& store) {
    std::vector<std::string> people;
    if (store.database() == nullptr) return people;
    for (const db::PersonRecord& person : db::PersonRepository(*store.database()).inUse())
        people.push_back(person.name);
    return people;
}

std::vector<ui::PractiseAssignment> assignmentsOf(run::Store& store, const std::string& person) {
    std::vector<ui::PractiseAssignment> given;
    if (store.database() == nullptr) return given;
    const auto known = db::PersonRepository(*store.database()).findByName(person);
    if (!known) return given;
    const core::Utc now = run::now();
    for (const db::AssignmentRecord& record :
         db::AssignmentRepository(*store.database()).openFor(known->id)) {
        const QDate due = QDateTime::fromSecsSinceEpoch(record.what.due.unix_s).date();
        given.push_back({record.what.scenarioKey, QString::fromStdString(record.what.scenarioName),
                         QLocale().toString(due, QLocale::ShortFormat), record.what.due.unix_s < now.unix_s,
                         record.what.type == db::RunType::SelfStudy, record.what.level});
    }
    return given;
}

/// A look into the database that may fail: what is asked is then as good as empty.
template <typename Look>
auto orNothing(Look&& look) -> decltype(look()) {
    try {
        return look();
    } catch (const db::DbError&) {
        return {};
    }
}

ui::PractisePorts portsOf(Frame& frame) {
    run::Store& store = frame.store();
    ui::PractisePorts ports;
    ports.people = orNothing([&] { return peopleOf(store); });
    ports.lessons = orNothing([&] { return entriesOf(store, DocumentKind::Scenario); });
    ports.vessels = orNothing([&] { return entriesOf(store, DocumentKind::Vessel); });
    ports.areas = orNothing([&] { return entriesOf(store, DocumentKind::Area); });
    ports.nameProblem = [](const std::string& name) {
        const auto good = db::personName(name);
        return good ? QString() : QString::fromUtf8(db::toText(good.error()).data());
    };
    ports.find = [&store](DocumentKind kind, const std::string& id) {
        return orNothing([&] { return store.find(kind, id); });
    };
    ports.documents =
        [&store](core::NamedText scenario) -> core::Result<core::ExerciseDocuments, std::string> {
        try {
            auto documents = core::collectDocuments(std::move(scenario), store);
            if (!documents) return documents.error().text();
            return std::move(documents).value();
        } catch (const db::DbError& error) {
            return std::string(error.what());
        }
    };
    ports.assignments = [&store](const std::string& person) {
        return orNothing([&] { return assignmentsOf(store, person); });
    };
    ports.history = [&store](const std::string& person) {
        return orNothing([&] { return pastRuns(store, person); });
    };
    return ports;
}

}  // namespace

ui::Page* practisePage(Frame& frame, PractiseWays ways) {
    ui::PractisePorts ports = portsOf(frame);
    auto* const voyage = new PractiseVoyage(frame, std::move(ways), nullptr);
    ports.sail = [voyage](std::shared_ptr<const core::World> world, const ui::PractiseChoice& choice) {
        return voyage->sail(std::move(world), choice);
    };
    ports.replay = [voyage](const std::string& recording, double time_s) {
        return voyage->replay(recording, time_s);
    };
    auto* const page = new ui::PractisePage(std::move(ports));
    voyage->setParent(page);
    return page;
}

}  // namespace sagara::station
