#include "app/station/DemoStationWall.h"

namespace sagara::station {
namespace {

/// Moments of one world of the run; of the last of them once the run shows another.
wall::MomentSource momentsOf(const DemoRun& run, std::shared_ptr<const core::World> world) {
    return [&run, world = std::move(world), clock = wall::FrameClock(),
            last = std::optional<wall::Moment>()]() mutable {
        if (auto now = run.momentForWall(*world, clock)) last = std::move(now);
        if (!last) last = wall::Moment{{}, core::view(*world, core::startState(*world, 1))};
        return *last;
    };
}

}  // namespace

void DemoStationWall::show() {
    if (m_run.world() == m_world) return;
    m_world = m_run.world();
    if (m_wall) m_wall->stop();
    m_before = std::move(m_wall);
    m_wall = std::make_unique<StationWall>(m_world, momentsOf(m_run, m_world));
    m_wall->start(m_layout, m_placement);
}

}  // namespace sagara::station
