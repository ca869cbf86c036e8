#pragma once

#include "core/exercise/Session.h"
#include "render/link/Interpolate.h"
#include "render/wall/WallServer.h"

namespace sagara::live {

/// An exercise without a clock: every frame is a fixed time after the one before, however long it takes to
/// draw.
class SteppedRun {
public:
    SteppedRun(std::shared_ptr<const core::World> world, core::State start,
               std::vector<core::Command> planned, double frame_s);
    void start() { m_started = true; }
    bool over() const { return m_session.over(); }
    wall::Moment next();

private:
    core::Session m_session;
    link::SnapshotTrail m_trail;
    double m_frame_s;
    std::int64_t m_frames = 0;
    std::int64_t m_first_us;
    bool m_started = false;
};

}  // namespace sagara::live
