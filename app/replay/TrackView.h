#pragma once

#include <optional>

#include "app/replay/Film.h"
#include "core/exercise/Snapshot.h"

namespace sagara::replay {

/// A recorded run seen through its kinematic track: any moment at once, in a straight line between samples.
/// Weather, lines and the rest are those of the last stored state that can be read, else of the start.
/// From one thread.
class TrackView {
public:
    explicit TrackView(std::shared_ptr<const Film> film) : m_film(std::move(film)) {}
    core::Snapshot at(core::SimTime time);

private:
    const core::Snapshot& backgroundAt(std::int64_t tick);

    std::shared_ptr<const Film> m_film;
    std::optional<core::Snapshot> m_background;
    std::size_t m_part = 0;  ///< the stored state m_background is of
};

}  // namespace sagara::replay
