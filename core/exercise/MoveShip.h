#pragma once

#include <array>
#include <vector>

#include "core/exercise/Event.h"
#include "core/exercise/TickLoads.h"

namespace sagara::core {

/// One own ship for one tick: pilot, machinery, loads, motion, lines, anchors, contact, ground.
void moveShip(const World& world, State& state, std::size_t index, const TickEnvironment& environment,
              std::vector<Event>& events);

/// Remembers how lines and anchors stood at the begin of a tick and reports what became of them.
class DeckWatch {
public:
    explicit DeckWatch(const State& state);
    void report(const World& world, const State& state, std::vector<Event>& events) const;

private:
    static constexpr std::size_t kMostShips = 8;
    struct Before {
        std::array<LineStatus, kMostLines> lines;
        std::array<AnchorStatus, kMostAnchors> anchors;
        std::array<bool, kMostAnchors> onBottom;
        std::array<double, kMostAnchors> dragged_m;
    };
    std::array<Before, kMostShips> m_before;
};

}  // namespace sagara::core
