#include <cmath>

#include "core/exercise/MoveShip.h"

namespace sagara::core {
namespace {

constexpr double kDragReport_m = 10.0;  // dragging is reported every so far

Event deckEvent(const State& state, EventKind kind, std::size_t ship, std::size_t index, NorthEast place,
                double value) {
    Event e;
    e.tick = state.tick;
    e.kind = kind;
    e.ship = static_cast<std::uint8_t>(ship);
    e.index = static_cast<std::int32_t>(index);
    e.place = place;
    e.value = value;
    return e;
}

}  // namespace

DeckWatch::DeckWatch(const State& state) : m_before() {
    for (std::size_t i = 0; i < state.ships.size(); ++i) {
        const OwnShipState& s = state.ships[i];
        for (std::size_t k = 0; k < kMostLines; ++k) m_before[i].lines[k] = s.lines[k].status;
        for (std::size_t k = 0; k < kMostAnchors; ++k) {
            m_before[i].anchors[k] = s.anchors[k].status;
            m_before[i].onBottom[k] = s.anchors[k].onBottom;
            m_before[i].dragged_m[k] = s.anchors[k].dragged_m;
        }
    }
}

void DeckWatch::report(const World& world, const State& state, std::vector<Event>& events) const {
    for (std::size_t i = 0; i < state.ships.size(); ++i) {
        const OwnShipState& s = state.ships[i];
        const Before& before = m_before[i];
        const HeadingFrame frame(s.motion.position(), s.motion.heading_rad);
        const auto add = [&](EventKind kind, std::size_t index, NorthEast place, double value) {
            events.push_back(deckEvent(state, kind, i, index, place, value));
        };
        for (std::size_t k = 0; k < world.ships[i]->lines.size(); ++k) {
            if (before.lines[k] == s.lines[k].status) continue;
            const NorthEast place = frame.point(world.ships[i]->lines[k].fairlead);
            if (s.lines[k].status == LineStatus::CastOff) add(EventKind::LineLetGo, k, place, 0.0);
            if (s.lines[k].status == LineStatus::In) add(EventKind::LineIn, k, place, 0.0);
            if (s.lines[k].status == LineStatus::Parted) add(EventKind::LineParted, k, place, 0.0);
        }
        for (std::size_t k = 0; k < world.ships[i]->anchorCount(); ++k) {
            const AnchorState& a = s.anchors[k];
            const NorthEast hawse = frame.point(world.ships[i]->vessel.groundTackle.anchors[k].hawse);
            const double ahead_mps = dot(s.shownOverGround_mps, unitVector(s.motion.heading_rad));
            if (before.anchors[k] == AnchorStatus::Home && a.status != AnchorStatus::Home) {
                add(EventKind::AnchorLetGo, k, hawse, ahead_mps);
            }
            if (before.anchors[k] != AnchorStatus::Home && a.status == AnchorStatus::Home)
                add(EventKind::AnchorHome, k, hawse, 0.0);
            if (before.anchors[k] != AnchorStatus::CableParted && a.status == AnchorStatus::CableParted) {
                add(EventKind::CableParted, k, hawse, 0.0);
            }
            if (!before.onBottom[k] && a.onBottom) add(EventKind::AnchorOnBottom, k, a.position, 0.0);
            if (std::floor(a.dragged_m / kDragReport_m) > std::floor(before.dragged_m[k] / kDragReport_m)) {
                add(EventKind::AnchorDragging, k, a.position, a.dragged_m);
            }
        }
    }
}

}  // namespace sagara::core
