#include "core/world/Target.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

constexpr double kArrival_m = 60.0;  // a waypoint counts as reached within this; small craft go nearer

bool isFast(const TargetLayout& layout) { return layout.type == TargetType::FastCraft; }
double speedLag_s(const TargetLayout& layout) { return isFast(layout) ? 4.0 : 5.0 + 0.4 * layout.length_m; }
double turningRadius_m(const TargetLayout& layout) { return (isFast(layout) ? 1.5 : 2.5) * layout.length_m; }

/// Whether a place lies so far inside her turning circle that no helm brings her within `near_m` of it: she
/// would go round it for ever.
bool insideTurningCircle(const TargetLayout& layout, const TargetState& state, NorthEast place,
                         double near_m) {
    const NorthEast ahead = unitVector(state.heading_rad);
    const double radius_m = turningRadius_m(layout), side = cross(ahead, place - state.position);
    const NorthEast centre = state.position + std::copysign(radius_m, side) * turnedRight(ahead);
    return distance(centre, place) < radius_m - near_m;
}

/// Along the points of a route, from the one numbered `leg`; stopped after the last unless it is a circuit.
TargetIntent follow(const TargetLayout& layout, const std::vector<TargetLayout::Waypoint>& route,
                    bool circuit, const TargetState& state, std::uint32_t& leg) {
    const auto count = static_cast<std::uint32_t>(route.size());
    const double arrival_m = std::min(kArrival_m, 3.0 * layout.length_m + 10.0);
    if (leg < count && distance(state.position, route[leg].position) < arrival_m) {
        ++leg;
        if (circuit && leg == count) leg = 0;
    }
    if (leg >= count) return {state.heading_rad, 0.0};
    const TargetLayout::Waypoint& to = route[leg];
    const bool last = !circuit && leg + 1 == count;
    const double left_m = distance(state.position, to.position);
    // She takes the way off over the last five lengths, or what her engine needs.
    const double stopping_m = std::max(5.0 * layout.length_m, 3.0 * speedLag_s(layout) * to.speed_mps);
    const double speed_mps =
        last ? std::min(to.speed_mps, to.speed_mps * left_m / stopping_m + 0.3) : to.speed_mps;
    // What she cannot turn to she first runs away from.
    const bool tooNear = insideTurningCircle(layout, state, to.position, 0.5 * arrival_m);
    return {tooNear ? state.heading_rad : bearing_rad(state.position, to.position), speed_mps};
}

}  // namespace

const char* targetTypeName(TargetType type) {
    switch (type) {
        case TargetType::Fishing:
            return "fishing";
        case TargetType::Coaster:
            return "coaster";
        case TargetType::Tanker:
            return "tanker";
        case TargetType::Container:
            return "container";
        case TargetType::Ferry:
            return "ferry";
        case TargetType::Yacht:
            return "yacht";
        case TargetType::Tug:
            return "tug";
        case TargetType::FastCraft:
            return "fastCraft";
    }
    return "";
}

double TargetLayout::mass_kg() const {
    constexpr double kBlock = 0.55;
    return kSeaWaterDensity_kgpm3 * kBlock * length_m * beam_m * draught_m;
}

Activity usualActivity(TargetType type, TargetBehaviour behaviour) {
    if (behaviour == TargetBehaviour::Lying) return Activity::Anchored;
    return type == TargetType::Yacht ? Activity::Sailing : Activity::UnderWay;
}

bool isSound(const TargetLayout& t) {
    const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
    constexpr double kFar_m = 500e3, kTurns_rad = 1000.0;
    const auto near = [&](NorthEast p) {
        return within(p.north_m, -kFar_m, kFar_m) && within(p.east_m, -kFar_m, kFar_m);
    };
    const bool points = std::all_of(t.route.begin(), t.route.end(), [&](const TargetLayout::Waypoint& w) {
        return near(w.position) && within(w.speed_mps, 0.0, kFastestTarget_mps);
    });
    const bool outline = std::all_of(t.outline.begin(), t.outline.end(), [&](BodyPoint p) {
        return within(p.x_m, -400.0, 400.0) && within(p.y_m, -400.0, 400.0);
    });
    return !t.route.empty() && points && t.outline.size() >= 3 && outline && t.type <= kLastTargetType &&
           t.behaviour <= kLastTargetBehaviour && t.activity <= kLastActivity &&
           within(t.length_m, 3.0, 400.0) && within(t.beam_m, 1.0, 70.0) && within(t.draught_m, 0.2, 25.0) &&
           within(t.heading_rad, -kTurns_rad, kTurns_rad);
}

Activity activityNow(const TargetLayout& layout, const TargetState& state) {
    // Whom the trainer has ordered off her berth is under way.
    if (state.underOrders() && !isUnderWay(layout.activity) && !state.stopped) return Activity::UnderWay;
    return state.stopped && isUnderWay(layout.activity) ? Activity::NotUnderCommand : layout.activity;
}

TargetState startOf(const TargetLayout& layout) {
    TargetState s;
    s.position = s.home = layout.route.front().position;
    s.leg = layout.route.size() > 1 ? 1 : 0;
    s.heading_rad =
        layout.route.size() > 1 ? bearing_rad(s.position, layout.route[1].position) : layout.heading_rad;
    const bool moves =
        layout.behaviour == TargetBehaviour::Route || layout.behaviour == TargetBehaviour::Circuit;
    s.speed_mps = moves && layout.route.size() > 1 ? layout.route[1].speed_mps : 0.0;
    if (layout.behaviour == TargetBehaviour::Course) s.speed_mps = layout.route.front().speed_mps;
    return s;
}

TargetIntent followOrders(const TargetLayout& layout, TargetState& state) {
    if (state.steered) return {state.orderedHeading_rad, std::max(0.0, state.orderedSpeed_mps)};
    return follow(layout, state.orderedRoute, false, state, state.orderedLeg);
}

void resumeOwn(TargetState& state) {
    state.stopped = state.steered = false;
    state.orderedSpeed_mps = -1.0;
    state.orderedRoute.clear();
    state.orderedLeg = 0;
}

TargetIntent followRoute(const TargetLayout& layout, TargetState& state) {
    if (layout.route.size() < 2) return {state.heading_rad, 0.0};
    return follow(layout, layout.route, layout.behaviour == TargetBehaviour::Circuit, state, state.leg);
}

void moveTarget(const TargetLayout& layout, TargetState& state, const TargetIntent& intent, NorthEast current,
                double dt_s) {
    const double wanted_mps = state.stopped                   ? 0.0
                              : state.orderedSpeed_mps >= 0.0 ? state.orderedSpeed_mps
                                                              : intent.speed_mps;
    state.speed_mps += (wanted_mps - state.speed_mps) / speedLag_s(layout) * dt_s;

    const double most_radps = std::min(state.speed_mps / turningRadius_m(layout), 0.35);
    const double error_rad = wrapPi(intent.heading_rad - state.heading_rad);
    const double turn_radps =
        std::clamp(0.15 * error_rad * (isFast(layout) ? 4.0 : 1.0), -most_radps, most_radps);
    const double turnLag_s = std::max(0.5, 0.08 * layout.length_m);
    state.yawRate_radps += (turn_radps - state.yawRate_radps) / turnLag_s * dt_s;
    state.heading_rad = wrapPi(state.heading_rad + state.yawRate_radps * dt_s);
    state.position = state.position + dt_s * (state.velocity() + current);
}

}  // namespace sagara::core
