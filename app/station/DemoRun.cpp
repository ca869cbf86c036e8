#include "app/station/DemoRun.h"

#include <cmath>

#include "core/base/Units.h"

namespace sagara::station {
namespace {

constexpr double kUnderWay_mps = 2.0 * core::kKnot_mps;

bool startsUnderWay(const core::State& first) {
    return !first.ships.empty() && std::abs(first.ships[0].motion.surge_mps) > kUnderWay_mps;
}

}  // namespace

void DemoRun::put(std::shared_ptr<const core::World> world, core::State first) {
    auto next = std::make_shared<live::LiveRun>(world, std::move(first),
                                                std::vector<core::Command>{{0, 0, core::PilotOrder{true}}});
    {
        const std::lock_guard lock(m_mutex);
        m_world.swap(world);
        m_live.swap(next);
        m_clock = wall::FrameClock();
    }
    if (next) next->stop();
}

std::shared_ptr<live::LiveRun> DemoRun::live() const {
    const std::lock_guard lock(m_mutex);
    return m_live;
}

ui::ExerciseRun::Picture DemoRun::toDraw() {
    wall::Moment moment = live()->toDraw(m_clock);
    return {moment.time, std::move(moment.snapshot)};
}

std::optional<wall::Moment> DemoRun::momentForWall(const core::World& shown, wall::FrameClock& clock) const {
    const std::lock_guard lock(m_mutex);
    if (m_world.get() != &shown) return std::nullopt;
    return m_live->toDraw(clock);
}

DemoLessons::DemoLessons(std::vector<std::shared_ptr<const core::World>> worlds, int level) {
    for (auto& world : worlds) {
        core::State first = core::startState(*world, level);
        m_lessons.push_back({std::move(world), std::move(first)});
    }
    for (std::size_t i = m_lessons.size(); i-- > 0;)
        if (startsUnderWay(m_lessons[i].first)) m_helmLesson = i;
    begin(0);
}

void DemoLessons::begin(std::size_t lesson) { m_run.put(m_lessons[lesson].world, m_lessons[lesson].first); }

}  // namespace sagara::station
