#pragma once

#include <deque>
#include <memory>

#include "core/exercise/Snapshot.h"

namespace sagara::link {

/// What is seen at a moment between two snapshots of one exercise. Positions and attitudes in a straight
/// line, directions the short way. A ship that was put elsewhere (farther than 200 m/s would take her) is not
/// drawn on the way. What a ship is doing, and whether a line is fast, is as the later says. The sea is that
/// of the later snapshot: its systems are exact, so every channel raises the same components.
core::Snapshot interpolated(const core::Snapshot& a, const core::Snapshot& b, core::SimTime time);

/// The last few snapshots of a run, and the picture at any moment among them. Not thread-safe.
class SnapshotTrail {
public:
    /// Newer than all before; an older one (the run was set back) begins the trail anew.
    void add(std::shared_ptr<const core::Snapshot> snapshot);
    bool empty() const { return m_trail.empty(); }
    core::SimTime newest() const { return m_trail.back()->time(); }
    /// Outside the trail: its nearest end. Not for an empty trail.
    core::Snapshot at(core::SimTime time) const;

private:
    static constexpr std::size_t kLongest = 16;
    std::deque<std::shared_ptr<const core::Snapshot>> m_trail;
};

}  // namespace sagara::link
