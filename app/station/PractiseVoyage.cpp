#include "app/station/PractiseVoyage.h"

#include <QDateTime>
#include <QTimer>
#include <algorithm>

#include "core/assess/Mission.h"
#include "db/GradeRepository.h"
#include "ui/chart/Format.h"
#include "ui/practise/SailResultPage.h"

namespace sagara::station {
namespace {

constexpr int kLook_ms = 500;
constexpr int kRunsAtOnce = 200, kMostRuns = 1000;  ///< of everybody, the newest

QString q(const std::string& utf8) { return QString::fromStdString(utf8); }

QString dateOf(core::Utc when) {
    return QLocale().toString(QDateTime::fromSecsSinceEpoch(when.unix_s).date(), QLocale::ShortFormat);
}

ui::PastRun pastRun(run::Store& store, const db::RunRecord& run) {
    ui::PastRun past;
    past.scenario = run.start.scenarioKey;
    past.name = q(run.start.scenarioName);
    past.when = dateOf(run.start.started);
    past.type = q(std::string(db::toText(run.start.type)));
    past.level = run.start.level;
    if (const auto grade = db::GradeRepository(*store.database()).find(run.id)) {
        past.graded = true;
        past.score = grade->score;
        past.passed = grade->passed;
    }
    const auto file = store.folder().pathOf(run.start.recordingFile);
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) past.recording = file.string();
    return past;
}

}  // namespace

std::vector<ui::PastRun> pastRuns(run::Store& store, const std::string& person) {
    std::vector<ui::PastRun> past;
    if (store.database() == nullptr) return past;
    const auto known = db::PersonRepository(*store.database()).findByName(person);
    if (!known) return past;
    const db::RunRepository runs(*store.database());
    for (db::Page page{kRunsAtOnce, 0}; page.offset < kMostRuns; page.offset += kRunsAtOnce) {
        const auto some = runs.list(page);
        for (const db::RunRecord& run : some)
            if (run.start.person == known->id && run.status != db::RunStatus::Running)
                past.push_back(pastRun(store, run));
        if (static_cast<int>(some.size()) < kRunsAtOnce) break;
    }
    return past;
}

PractiseVoyage::PractiseVoyage(Frame& frame, PractiseWays ways, QObject* parent)
    : QObject(parent), m_frame(frame), m_ways(std::move(ways)), m_watch(new QTimer(this)) {
    connect(m_watch, &QTimer::timeout, this, [this] {
        if (m_run && m_run->over()) finish();
    });
}

std::optional<std::string> PractiseVoyage::sail(std::shared_ptr<const core::World> world,
                                                const ui::PractiseChoice& choice) {
    m_world = std::move(world);
    m_choice = choice;
    return begin(false);
}

std::optional<std::string> PractiseVoyage::begin(bool inPlaceOfResult) {
    if (m_run) return "a run is open already";
    RunRequest request;
    request.scenario = m_world->scenarioId;
    request.level = m_choice.level;
    request.type = "self-study";
    request.trainee = m_choice.person;
    auto opened = StationRun::open(m_frame.store(), request, m_world);
    if (!opened) return opened.error();
    m_run = std::move(opened).value();
    m_console = m_ways.console(*m_run, {m_choice.prediction, m_choice.hints, m_choice.chart});
    // The run goes after the page that looks at it, whichever way that goes.
    connect(m_console, &QObject::destroyed, m_console, [run = m_run] {});
    // Left: at once no more, for the window is in the middle of taking the page away.
    connect(
        m_console, &QObject::destroyed, this, [this] { finish(); }, Qt::QueuedConnection);
    if (inPlaceOfResult)
        m_frame.replacePage(m_console);
    else
        m_frame.openPage(m_console);
    m_watch->start(kLook_ms);
    return std::nullopt;
}

std::optional<std::string> PractiseVoyage::replay(const std::filesystem::path& recording, double time_s) {
    return m_ways.debrief ? m_ways.debrief(recording, time_s) : m_frame.openDebrief(recording);
}

void PractiseVoyage::finish() {
    if (!m_run) return;  // its result is on the screen already
    m_watch->stop();
    const std::shared_ptr<StationRun> run = std::move(m_run);
    m_run.reset();
    const run::RunSummary& summary = run->end();
    ui::SailResult result = resultOf(summary);
    result.recording = run->recording().string();
    result.trouble = q(run->trouble());
    ui::SailResultPage::Ports ports;
    ports.replay = [this, file = run->recording()](double time_s) { return replay(file, time_s); };
    ports.again = [this] { return begin(true); };
    auto* const page = new ui::SailResultPage(std::move(result), std::move(ports));
    if (m_console && m_console->isVisible())
        m_frame.replacePage(page);
    else
        m_frame.openPage(page);
}

ui::SailResult PractiseVoyage::resultOf(const run::RunSummary& s) const {
    ui::SailResult result;
    result.name = q(m_world->scenarioName);
    result.graded = !m_world->mission.criteria.empty();
    result.passed = s.passed;
    result.score = s.score;
    result.whyNot = q(s.whyNot);
    result.sailed_s = s.simTime_s;
    for (const auto& task : s.tasks) result.tasks.push_back({q(task.title), task.done, task.time_s});
    for (const auto& loss : s.losses)
        result.losses.push_back({loss.time_s, q(loss.title),
                                 tr("%1 %2 %3, limit %4 %3")
                                     .arg(q(loss.quantity), chart::shortNumber(loss.value, 2), q(loss.unit),
                                          chart::shortNumber(loss.limit, 2)),
                                 loss.points, loss.fails});
    if (m_choice.person.empty() || !result.graded) return result;
    double best = -1.0;
    for (const ui::PastRun& past : pastRuns(m_frame.store(), m_choice.person))
        if (past.graded && past.scenario == m_world->scenarioId) best = std::max(best, past.score);
    if (best >= 0.0) result.best = tr("Your best here: %1 of 100").arg(best, 0, 'f', 0);
    return result;
}

}  // namespace sagara::station
