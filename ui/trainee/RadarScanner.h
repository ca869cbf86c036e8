#pragma once

#include "core/bridge/Radar.h"
#include "core/exercise/Snapshot.h"

namespace sagara::ui::console {

/// Turns the antenna of one own ship with the time of the exercise and keeps the picture. No widget.
class RadarScanner {
public:
    RadarScanner(const core::World& world, std::size_t ship);

    /// A new range starts with an empty picture, filled by one whole turn.
    void setRange(double range_m);
    /// Sweeps what the antenna has passed since the last call; a whole turn at most, and at once when time
    /// has jumped or nothing was swept yet.
    void advance(core::SimTime time, const core::Snapshot& now);

    const core::RadarPicture& picture() const { return m_picture; }
    /// The azimuth swept last.
    std::size_t azimuth() const { return m_azimuth; }
    core::NorthEast antenna() const { return m_antenna; }

private:
    std::vector<core::RadarObject> objectsNow(const core::Snapshot& now) const;

    const core::World& m_world;
    std::size_t m_ship;
    core::RadarCoast m_coast;
    core::RadarSet m_set;
    std::vector<core::RadarObject> m_marks;
    core::RadarPicture m_picture;
    core::NorthEast m_antenna;
    std::size_t m_azimuth = 0;
    double m_swept = 0.0;  ///< steps since the start, whole turns included
    bool m_fresh = true;
};

}  // namespace sagara::ui::console
