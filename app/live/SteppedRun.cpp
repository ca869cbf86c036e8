#include "app/live/SteppedRun.h"

#include <cmath>

namespace sagara::live {
namespace {

std::shared_ptr<const core::Snapshot> snapshotOf(const core::Session& session) {
    return std::make_shared<const core::Snapshot>(core::view(session.world(), session.state()));
}

}  // namespace

SteppedRun::SteppedRun(std::shared_ptr<const core::World> world, core::State start,
                       std::vector<core::Command> planned, double frame_s)
    : m_session(std::move(world), std::move(start), std::move(planned), nullptr),
      m_frame_s(frame_s),
      m_first_us(m_session.state().time().us) {
    m_trail.add(snapshotOf(m_session));
}

wall::Moment SteppedRun::next() {
    if (m_started) ++m_frames;
    const core::SimTime time{m_first_us + static_cast<std::int64_t>(
                                              std::llround(1e6 * m_frame_s * static_cast<double>(m_frames)))};
    while (m_trail.newest() < time && !m_session.over()) {
        (void)m_session.step();
        m_trail.add(snapshotOf(m_session));
    }
    return {time, m_trail.at(time)};
}

}  // namespace sagara::live
