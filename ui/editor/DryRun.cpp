#include "ui/editor/DryRun.h"

#include <algorithm>
#include <chrono>

#include "core/exercise/Session.h"
#include "core/exercise/World.h"
#include "ui/chart/Format.h"
#include "ui/editor/FieldSpec.h"
#include "ui/editor/Validator.h"

namespace sagara::ui::editor {
namespace {

DryRunResult::Loss lossOf(const core::World& world, const core::Event& event) {
    const core::Criterion& criterion = *world.mission.criteria[static_cast<std::size_t>(event.index)];
    const core::Display display = criterion.display();
    const QString unit = QString::fromUtf8(display.unit);
    DryRunResult::Loss loss;
    loss.id = QString::fromStdString(criterion.terms().id);
    loss.title = QString::fromStdString(criterion.terms().title);
    loss.found =
        words("%1 %2 %3, limit %4 %3")
            .arg(QString::fromUtf8(display.quantity), chart::shortNumber(event.value / display.perUnit, 2),
                 unit, chart::shortNumber(event.limit / display.perUnit, 2));
    loss.time_s = event.time().seconds();
    loss.points = event.points;
    loss.place = event.place;
    return loss;
}

void take(const core::World& world, const std::vector<core::Event>& events, DryRunResult& result) {
    for (const core::Event& e : events) {
        if (e.kind == core::EventKind::Deduction) result.losses.push_back(lossOf(world, e));
        if (e.kind == core::EventKind::MissionFailed)
            result.failedBy = QString::fromStdString(
                world.mission.criteria[static_cast<std::size_t>(e.index)]->terms().title);
    }
}

void conclude(const core::World& world, const core::State& state, DryRunResult& result) {
    const core::Assessment& assessment = state.assessment;
    result.passed = core::passed(world.mission, assessment);
    result.score = core::scoreOf(assessment);
    result.passScore = world.mission.passScore;
    result.time_s = state.time().seconds();
    for (std::size_t i = 0; i < world.mission.tasks.size(); ++i) {
        const core::TaskMemory& memory = assessment.tasks[i];
        result.tasks.push_back({QString::fromStdString(world.mission.tasks[i]->id()),
                                QString::fromStdString(world.mission.tasks[i]->title()), memory.done,
                                memory.doneAt.seconds()});
    }
    std::stable_sort(result.losses.begin(), result.losses.end(),
                     [](const auto& a, const auto& b) { return a.time_s < b.time_s; });
}

}  // namespace

QString runTime(double time_s) {
    const int whole = static_cast<int>(time_s);
    const auto two = [](int n) { return QStringLiteral("%1").arg(n, 2, 10, QLatin1Char('0')); };
    const QString tail = two(whole / 60 % 60) + u':' + two(whole % 60);
    return whole < 3600 ? tail : QString::number(whole / 3600) + u':' + tail;
}

DryRun::~DryRun() {
    m_cancel = true;
    if (m_thread.joinable()) m_thread.join();
}

void DryRun::start(std::string scenario, std::shared_ptr<const core::DocumentSource> documents, int level) {
    if (m_running) return;
    if (m_thread.joinable()) m_thread.join();
    m_running = true;
    m_cancel = false;
    m_progress = {};
    m_thread = std::thread([this, scenario = std::move(scenario), documents = std::move(documents), level] {
        DryRunResult result = sail(scenario, *documents, level);
        QMetaObject::invokeMethod(
            this,
            [this, result = std::move(result)] {
                m_result = result;
                m_running = false;
                Q_EMIT finished();
            },
            Qt::QueuedConnection);
    });
}

DryRun::Progress DryRun::progress() const {
    const std::lock_guard lock(m_mutex);
    return m_progress;
}

DryRunResult DryRun::sail(const std::string& scenario, const core::DocumentSource& documents, int level) {
    DryRunResult result;
    auto built = worldOf(scenario, documents, core::WorldUse::Sail);
    if (!built) return result.problems = built.error(), result;
    const std::shared_ptr<const core::World> world = std::move(built).value();
    const auto begun = std::chrono::steady_clock::now();
    core::Session session(world, core::startState(*world, level), {{0, 0, core::PilotOrder{true}}}, nullptr);
    std::int64_t shown_s = -1;
    while (!session.over() && !m_cancel) {
        take(*world, session.step(), result);
        const core::State& state = session.state();
        const std::int64_t second = state.time().us / 1'000'000;
        if (second == shown_s) continue;
        shown_s = second;
        result.track.points.push_back({state.time().seconds(), state.ships[0].motion.position()});
        const std::size_t task = state.assessment.currentTask;
        const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        const std::lock_guard lock(m_mutex);
        m_progress = {state.time().seconds(), world->longest_s,
                      task < world->mission.tasks.size()
                          ? QString::fromStdString(world->mission.tasks[task]->title())
                          : words("all tasks done"),
                      core::scoreOf(state.assessment), state.time().seconds() / std::max(wall_s, 0.01)};
    }
    result.cancelled = m_cancel && !session.over();
    conclude(*world, session.state(), result);
    return result;
}

}  // namespace sagara::ui::editor
