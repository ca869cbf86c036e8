#include "app/station/DebriefDoor.h"

#include <QCoreApplication>
#include <fstream>

#include "app/replay/BranchRun.h"
#include "app/replay/NotesFile.h"
#include "app/replay/ReplayRun.h"
#include "app/station/SettingsDoor.h"
#include "db/DbError.h"
#include "db/GradeRepository.h"
#include "db/PersonRepository.h"
#include "db/RunRepository.h"
#include "ui/debrief/DebriefDesk.h"
#include "ui/debrief/DebriefPage.h"
#include "ui/debrief/RecordingsPage.h"

namespace sagara::station {
namespace {

namespace fs = std::filesystem;

constexpr int kMostListed = 2000;

QString tr(const char* text) { return QCoreApplication::translate("sagara::station::DebriefDoor", text); }

core::Result<std::unique_ptr<ui::Replay>, std::string> openReplay(const fs::path& file,
                                                                  ui::OpenProgress& progress,
                                                                  std::shared_ptr<core::SeaHulls> hulls) {
    const auto keepOn = [&progress](double done) {
        progress.permille = static_cast<int>(900.0 * done);
        return !progress.cancelled;
    };
    auto film = replay::openFilm(file, keepOn, std::move(hulls));
    if (!film) return film.error();
    ui::ReplayResult result = replay::resultOf(**film);
    return std::unique_ptr<ui::Replay>(
        std::make_unique<replay::ReplayRun>(std::move(film).value(), std::move(result)));
}

QString typeName(db::RunType type) {
    switch (type) {
        case db::RunType::Familiarise:
            return tr("Familiarisation");
        case db::RunType::Train:
            return tr("Training");
        case db::RunType::Assess:
            return tr("Assessment");
        case db::RunType::SelfStudy:
            return tr("Self-study");
        case db::RunType::Demo:
            return tr("Demonstration");
    }
    return {};
}

QString stateName(db::RunStatus status) {
    switch (status) {
        case db::RunStatus::Running:
            return tr("under way or broken off");
        case db::RunStatus::Finished:
            return tr("finished");
        case db::RunStatus::Aborted:
            return tr("ended early");
    }
    return {};
}

std::vector<ui::RecordingEntry> entriesOf(run::Store& store) {
    std::vector<ui::RecordingEntry> entries;
    if (store.database() == nullptr) return entries;
    db::Database& database = *store.database();
    const db::GradeRepository grades(database);
    const db::PersonRepository people(database);
    for (const db::RunRecord& run : db::RunRepository(database).list({kMostListed, 0})) {
        ui::RecordingEntry entry;
        entry.started = QDateTime::fromSecsSinceEpoch(run.start.started.unix_s);
        entry.scenario = QString::fromStdString(run.start.scenarioName);
        const auto person = run.start.person ? people.find(*run.start.person) : std::nullopt;
        if (person) entry.trainee = QString::fromStdString(person->name);
        entry.type = typeName(run.start.type);
        if (const auto grade = grades.find(run.id)) {
            entry.score = grade->score;
            entry.passed = grade->passed;
        }
        entry.length_s = run.simTime.seconds();
        entry.state = stateName(run.status);
        const fs::path file = store.folder().pathOf(run.start.recordingFile);
        entry.file = QString::fromStdString(file.string());
        std::error_code ignored;
        entry.present = fs::is_regular_file(file, ignored);
        entries.push_back(std::move(entry));
    }
    return entries;
}

/// The choice of plots, from one debriefing to the next.
void keepPlots(ui::DebriefPage& page, Frame& frame) {
    constexpr const char* kPlots = "ui.debrief-plots";
    const std::shared_ptr<ui::SettingsStore> settings = settingsStore(frame);
    if (const auto kept = settings->get(kPlots)) page.desk()->showPlots(QString::fromStdString(*kept));
    QObject::connect(page.desk(), &ui::DebriefDesk::plotsChosen, page.desk(), [desk = page.desk(), settings] {
        settings->put(kPlots, desk->plotsShown().toStdString());
    });
}

/// Empty when it may be a recording; the rest is found out aside.
std::string whyNotARecording(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    char begin[8] = {};
    if (!in.read(begin, sizeof begin))
        return file.string() + ": cannot be read, or is too short to be a recording";
    if (std::string_view(begin, sizeof begin) != "SGRREC01")
        return file.string() + ": is not a Sagara recording (.sgr)";
    return {};
}

}  // namespace

ui::DebriefPorts debriefPorts(run::Store& store, const fs::path& recording) {
    ui::DebriefPorts ports;
    ports.open = [recording, hulls = store.hulls()](ui::OpenProgress& progress) {
        return openReplay(recording, progress, hulls);
    };
    ports.branch = [&store](const ui::Replay& replay,
                            core::State from) -> core::Result<std::unique_ptr<ui::Branch>, std::string> {
        auto branch = replay::BranchRun::open(
            store, static_cast<const replay::ReplayRun&>(replay).sharedFilm(), std::move(from));
        if (!branch) return branch.error();
        return std::unique_ptr<ui::Branch>(std::move(branch).value());
    };
    const replay::NotesFile notes(recording);
    ports.notes = [notes] { return notes.read(); };
    ports.addNote = [notes](const ui::DebriefNote& note) { return notes.add(note); };
    return ports;
}

core::Result<ui::Page*, std::string> debriefPage(Frame& frame, const fs::path& recording,
                                                 std::function<void()> openResult, double from_s) {
    if (const std::string why = whyNotARecording(recording); !why.empty()) return why;
    ui::DebriefPorts ports = debriefPorts(frame.store(), recording);
    ports.stage = [&frame](const std::shared_ptr<const core::World>& world) { return frame.stageFor(world); };
    ports.openResult = std::move(openResult);
    auto* const page =
        new ui::DebriefPage(std::move(ports), QString::fromStdString(recording.filename().string()));
    QObject::connect(page, &ui::DebriefPage::opened, page, [page, &frame] { keepPlots(*page, frame); });
    if (from_s > 0.0)
        QObject::connect(page, &ui::DebriefPage::opened, page,
                         [page, from_s] { page->desk()->goTo({static_cast<std::int64_t>(1e6 * from_s)}); });
    return static_cast<ui::Page*>(page);
}

ui::Page* recordingsPage(Frame& frame) {
    run::Store& store = frame.store();
    ui::RecordingsPorts ports;
    ports.list = [&store]() -> std::vector<ui::RecordingEntry> {
        try {
            return entriesOf(store);
        } catch (const db::DbError&) {
            return {};
        }
    };
    ports.open = [&frame](const QString& file) -> std::optional<QString> {
        const auto trouble = frame.openDebrief(file.toStdString());
        return trouble ? std::optional(QString::fromStdString(*trouble)) : std::nullopt;
    };
    ports.folder = QString::fromStdString(store.folder().recordings().string());
    if (store.database() == nullptr)
        ports.trouble =
            tr("The list of runs cannot be read: %1").arg(QString::fromStdString(store.trouble()));
    return new ui::RecordingsPage(std::move(ports));
}

}  // namespace sagara::station
