#include "core/exercise/Observe.h"

#include <algorithm>

#include "core/exercise/LocalWater.h"

namespace sagara::core {
namespace {

/// Hull to hull, exact to the length of an outline's side when they are near, centre distance less radii when
/// far.
double clearance_m(const OwnShip& ship, const HeadingFrame& frame, NorthEast position,
                   const TargetLayout& layout, const TargetState& target) {
    const double far_m = distance(position, target.position) - ship.hull.radius_m - 0.5 * layout.length_m;
    if (far_m > 4.0 * ship.hull.radius_m) return far_m;
    const HeadingFrame theirs(target.position, target.heading_rad);
    double least_m = 1e9;
    for (const BodyPoint& own : ship.hull.outline) {
        const NorthEast p = frame.point(own);
        for (std::size_t i = 0, j = layout.outline.size() - 1; i < layout.outline.size(); j = i++) {
            const Segment side{theirs.point(layout.outline[j]), theirs.point(layout.outline[i])};
            least_m = std::min(least_m, distanceTo(side, p));
        }
    }
    return least_m;
}

}  // namespace

NorthEast overGround_mps(const OwnShipState& ship, NorthEast current) {
    const HeadingFrame frame({}, ship.motion.heading_rad);
    return frame.vector({ship.motion.surge_mps, ship.motion.sway_mps}) + current;
}

double clearOfShore_m(const Area& area, const OwnShip& ship, const ShipMotion& m) {
    const double reach_m = kShoreLimit_m + ship.hull.radius_m;
    if (area.shore.distance_m(m.position(), reach_m) >= reach_m) return kShoreLimit_m;
    const HeadingFrame frame(m.position(), m.heading_rad);
    double least_m = kShoreLimit_m;
    for (const BodyPoint& p : ship.hull.outline) least_m = area.shore.distance_m(frame.point(p), least_m);
    return least_m;
}

Observation observe(const World& world, const State& state, std::size_t index) {
    const OwnShip& ship = *world.ships[index];
    const OwnShipState& s = state.ships[index];
    const ShipMotion& m = s.motion;
    Observation o;
    o.time = state.time();
    o.level = state.level;
    o.position = m.position();
    o.heading_rad = m.heading_rad;
    o.overGround_mps = s.shownOverGround_mps;
    o.momentarySpeed_mps = length(overGround_mps(s, currentAt(world, state, m.position())));
    o.alongGround_mps = dot(o.overGround_mps, unitVector(m.heading_rad));
    o.underKeel_m = s.underKeel_m;
    o.clearOfShore_m = clearOfShore_m(world.area, ship, m);
    o.windFrom_rad = state.weather.now.wind.windFrom_rad;
    const HeadingFrame frame(m.position(), m.heading_rad);
    o.clearOfShips_m = kShipsLimit_m;
    for (std::size_t i = 0; i < state.targets.size(); ++i) {
        const TargetLayout& layout = targetLayout(world, state, i);
        if (!state.targets[i].present || layout.behaviour == TargetBehaviour::Hostile) continue;
        const double clear_m = clearance_m(ship, frame, m.position(), layout, state.targets[i]);
        o.clearOfShips_m = std::min(o.clearOfShips_m, clear_m);
    }
    for (std::size_t i = 0; i < kMostLines; ++i) {
        const auto bit = static_cast<std::uint8_t>(1U << i);
        if (s.lines[i].onBollard()) o.linesFast |= bit;
        if (s.lines[i].onBollard() || s.lines[i].status == LineStatus::CastOff) o.linesOut |= bit;
    }
    for (std::size_t i = 0; i < kMostAnchors; ++i) {
        const AnchorState& a = s.anchors[i];
        o.anchors[i] = {a.onBottom, a.position, a.cableOut_m, a.dragged_m, a.dragSpeed_mps};
    }
    return o;
}

std::optional<Happening> happeningOf(const Event& event) {
    Happening h;
    h.time = event.time();
    h.place = event.place;
    h.contact = event.contact;
    h.speed_mps = event.value;
    h.energy_J = event.energy_J;
    switch (event.kind) {
        case EventKind::AnchorLetGo:
            h.kind = Happening::Kind::AnchorLetGo;
            return h;
        case EventKind::Contact:
            h.kind = Happening::Kind::Contact;
            return h;
        case EventKind::Grounding:
            h.kind = Happening::Kind::Grounding;
            return h;
        case EventKind::LineParted:
            h.kind = Happening::Kind::LineParted;
            return h;
        case EventKind::CableParted:
            h.kind = Happening::Kind::CableParted;
            return h;
        default:
            return std::nullopt;
    }
}

}  // namespace sagara::core
