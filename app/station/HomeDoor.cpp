#include <QCoreApplication>
#include <QLabel>

#include "app/files/AssetSource.h"
#include "app/files/Files.h"
#include "app/station/BrokenOff.h"
#include "app/station/DebriefDoor.h"
#include "app/station/DemoDoor.h"
#include "app/station/DeskPage.h"
#include "app/station/Doors.h"
#include "app/station/EditorDoor.h"
#include "app/station/RosterDoor.h"
#include "app/station/Station.h"
#include "app/station/VesselsDoor.h"
#include "core/exercise/BuildId.h"
#include "db/DbError.h"
#include "ui/help/AboutDialog.h"
#include "ui/start/HomePage.h"

namespace sagara::station {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("Doors", text); }

/// On the page of the doors, once.
void tell(Station& station, const QString& words) {
    auto* const home = dynamic_cast<ui::HomePage*>(station.page());
    if (home == nullptr) return;
    for (const QLabel* said : home->findChildren<QLabel*>(QStringLiteral("notice-text")))
        if (said->text() == words) return;
    home->addNotice(words);
}

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
    QString begun = QString::fromStdString(core::formatUtc(run.started));
    begun.replace(QLatin1Char('T'), QLatin1Char(' ')).replace(QLatin1Char('Z'), QStringLiteral(" UTC"));
    home.addNotice(tr("A run was broken off: %1, %2, begun %3, saved up to %4.")
                       .arg(QString::fromStdString(run.scenarioName), who, begun,
                            QString::fromStdString(run::clock(run.sailed_s))),
                   std::move(ways));
}

/// The first stick that is plugged in, as a visitor holds it: to starboard and forward are positive.
std::optional<ui::StickReading> stickOf(const ui::Joysticks& sticks) {
    const auto devices = sticks.devices();
    if (devices.empty()) return std::nullopt;
    const ui::JoystickInfo& stick = devices.front();
    ui::StickReading reading{sticks.axis(stick.id, 0), -sticks.axis(stick.id, 1)};
    for (int i = 0; i < stick.buttons; ++i) reading.pressed = reading.pressed || sticks.button(stick.id, i);
    return reading;
}

DemoOptions demoOptions(Station& station, const std::string& wallLayout) {
    DemoOptions options;
    options.wallLayout = wallLayout;
    options.stick = [&station] { return stickOf(station.input().joysticks()); };
    return options;
}

/// Without the bar, unless the page only tells why there is no demo.
void showDemo(Station& station, ui::Page* page) {
    station.openPage(page);
    station.setBarShown(qobject_cast<ui::DemoPage*>(page) == nullptr);
}

ui::AboutFacts aboutFacts(Station& station) {
    ui::AboutFacts facts;
    facts.version = QStringLiteral(SAGARA_VERSION);
    facts.buildId = QString::fromStdString(std::string(core::coreBuildId()));
    if (const auto text = files::readTextFile(files::assetFolder() / "ATTRIBUTION.md"))
        facts.attributions = QString::fromStdString(*text);
    const std::pair<core::DocumentKind, QString> kinds[] = {{core::DocumentKind::Area, tr("Area: %1")},
                                                            {core::DocumentKind::Vessel, tr("Vessel: %1")}};
    for (const auto& [kind, title] : kinds) {
        for (const std::string& id : station.store().assets().ids(kind)) {
            const auto text = station.store().assets().find(kind, id);
            const QStringList lines = text ? ui::attributionOf(*text) : QStringList();
            if (!lines.isEmpty()) facts.credits.push_back({title.arg(QString::fromStdString(id)), lines});
        }
    }
    return facts;
}

}  // namespace

ui::Page* homePage(Station& station) {
    const auto room = [&station](const char* id, const QString& name, const QString& tip, auto make) {
        return ui::Room{name, tip, QStringLiteral("door-%1").arg(QLatin1String(id)), [&station, make] {
                            try {
                                station.openPage(make(station));
                            } catch (const db::DbError& e) {
                                tell(station, QString::fromUtf8(e.what()));
                            }
                        }};
    };
    std::vector<ui::Door> doors;
    doors.push_back(
        {tr("Teach"),
         QStringLiteral("user-profiles"),
         tr("Trainers run lessons from the desk, write them, keep the roster and debrief."),
         {room("lesson", tr("Run a lesson"), tr("Choose an exercise and open the trainer's desk"),
               lessonPage),
          room("editor", tr("Edit lessons"),
               tr("Write a lesson on the chart, check it, let the pilot sail it"),
               [](Station& s) { return editorPage(s); }),
          room("roster", tr("Roster"), tr("Trainees, classes, assignments, every run and its assessment"),
               [](Station& s) { return rosterPage(s); }),
          room("debrief", tr("Debrief"), tr("Replay a run, and sail it differently from any second"),
               [](Station& s) { return recordingsPage(s); })}});
    doors.push_back(
        {tr("Train"),
         QStringLiteral("conning-iec"),
         tr("Trainees sail a lesson from their own console: helm, engines, radar, chart, sonar."),
         {room("train", tr("Take a watch"), tr("Choose a lesson and go to the bridge"), watchPage)}});
    doors.push_back(
        {tr("Practise"),
         QStringLiteral("route-monitoring-proposal"),
         tr("Sail alone, any ship, place and weather, or a lesson with hints and your own history."),
         {room("practise", tr("Practise"), tr("Choose who you are, a ship, a place and the weather"),
               alonePage)}});
    doors.push_back(
        {tr("Vessels"),
         QStringLiteral("ship-navy"),
         tr("Administrators keep ships and the database: look, add, test, print a pilot card."),
         {room("vessels", tr("Vessels"), tr("Every ship with its data, where they come from, and its trials"),
               [](Station& s) { return vesselsPage(s); }),
          room("database", tr("Database"), tr("Size, integrity, backup and restore"),
               [](Station& s) { return databasePage(s); })}});
    doors.push_back(
        {tr("Demo"),
         QStringLiteral("view-gallery-google"),
         tr("Exhibitions: the pilot sails, cameras change, and whoever touches a key takes the helm."),
         {{tr("Start the demo"), tr("Full screen; it is left by a chord of keys and a PIN"),
           QStringLiteral("door-demo"),
           [&station] { showDemo(station, demoPage(station, demoOptions(station, {}))); }}}});
    auto* const home = new ui::HomePage(std::move(doors));
    for (const std::string& message : run::RunFiling(station.store()).fileNoted())
        home->addNotice(QString::fromStdString(message));
    for (const BrokenOff& run : brokenOffRuns(station.store())) offerToGoOn(station, *home, run);
    if (!station.store().trouble().empty())
        home->addNotice(QString::fromStdString(station.store().trouble()));
    return home;
}

std::optional<std::string> enterDemo(Station& station, const std::string& wallLayout) {
    auto page = openDemo(station, demoOptions(station, wallLayout));
    if (!page) return page.error();
    showDemo(station, *page);
    return std::nullopt;
}

ui::Page* adminPage(Station& station) { return vesselsPage(station); }

void about(Station& station) { ui::showAbout(&station, aboutFacts(station)); }

}  // namespace sagara::station
