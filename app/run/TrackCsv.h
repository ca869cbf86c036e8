#pragma once

#include <string>

#include "core/exercise/Track.h"
#include "core/exercise/World.h"

namespace sagara::run {

/// Rows of a track file, one for each own ship and moment. Heave is positive downward, roll with the
/// starboard side down, pitch with the bow up; shaft_rpm is the mean of the shafts; score is that of the
/// first ship.
class TrackCsv {
public:
    explicit TrackCsv(const core::World& world);
    void add(const core::TrackSample& sample);
    const std::string& text() const { return m_text; }

private:
    const core::World& m_world;
    std::string m_text;
};

}  // namespace sagara::run
