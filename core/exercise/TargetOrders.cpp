#include "core/exercise/TargetOrders.h"

#include <algorithm>

#include "core/base/Angle.h"
#include "core/exercise/State.h"
#include "core/vessel/Hull.h"

namespace sagara::core {
namespace {

constexpr std::size_t kLongestName_bytes = 60;

/// The layout of an added ship; not yet checked.
TargetLayout layoutOf(const AddTargetOrder& order, std::size_t number) {
    TargetLayout t;
    t.id = "added-" + std::to_string(number);
    t.name = order.name;
    t.type = order.type;
    t.length_m = order.length_m;
    t.beam_m = order.beam_m;
    t.draught_m = order.draught_m;
    t.heading_rad = order.heading_rad;
    t.onEvent = true;  // no level brings or takes her
    t.route.push_back({order.position, order.speed_mps});
    t.behaviour = order.speed_mps > 0.0 ? TargetBehaviour::Course : TargetBehaviour::Lying;
    if (!order.route.empty()) {
        t.route.insert(t.route.end(), order.route.begin(), order.route.end());
        t.behaviour = TargetBehaviour::Route;
    }
    if (order.hostile) t.behaviour = TargetBehaviour::Hostile;
    t.activity = order.activity;
    if (t.behaviour == TargetBehaviour::Lying && isUnderWay(order.activity))
        t.activity = order.activity == Activity::UnderWay ? Activity::Anchored : order.activity;
    if (t.behaviour != TargetBehaviour::Lying && !isUnderWay(order.activity)) t.activity = Activity::UnderWay;
    return t;
}

/// As if for a new ship there: the same limits hold.
bool canBeAt(const TargetLayout& like, NorthEast position, double heading_rad, double speed_mps) {
    TargetLayout there = like;
    there.route = {{position, speed_mps}};
    there.heading_rad = heading_rad;
    return isSound(there);
}

}  // namespace

bool carryOut(const World& world, State& state, const AddTargetOrder& order) {
    if (state.added.size() >= kMostAddedTargets || order.route.size() > kLongestTargetRoute ||
        order.name.size() > kLongestName_bytes)
        return false;
    TargetLayout layout = layoutOf(order, state.added.size() + 1);
    layout.outline.resize(3);  // the real one only for sizes that are sound
    if (!isSound(layout)) return false;
    layout.outline = outlineOf(layout.length_m, layout.beam_m);
    TargetState target = startOf(layout);
    target.present = true;
    // Near where she heads for she turns to it; the trainer has said how she lies.
    target.heading_rad = wrapPi(order.heading_rad);
    target.speed_mps = layout.behaviour == TargetBehaviour::Lying ? 0.0 : order.speed_mps;
    state.added.push_back(std::move(layout));
    state.targets.push_back(std::move(target));
    return state.targets.size() == world.targets.size() + state.added.size();
}

bool carryOut(const World& world, State& state, const MoveTargetOrder& order) {
    if (order.target >= state.targets.size()) return false;
    const TargetLayout& layout = targetLayout(world, state, order.target);
    if (!canBeAt(layout, order.position, order.heading_rad, 0.0)) return false;
    TargetState& target = state.targets[order.target];
    target.position = target.home = order.position;
    target.heading_rad = wrapPi(order.heading_rad);
    target.yawRate_radps = 0.0;
    return true;
}

bool carryOut(const World& world, State& state, const SteerTargetOrder& order) {
    if (order.target >= state.targets.size()) return false;
    TargetState& target = state.targets[order.target];
    const TargetLayout& layout = targetLayout(world, state, order.target);
    if (!canBeAt(layout, target.position, order.heading_rad, order.speed_mps)) return false;
    resumeOwn(target);
    target.steered = true;
    target.orderedHeading_rad = wrapPi(order.heading_rad);
    target.orderedSpeed_mps = order.speed_mps;
    return true;
}

bool carryOut(const World& world, State& state, const RouteTargetOrder& order) {
    if (order.target >= state.targets.size() || order.points.empty() ||
        order.points.size() > kLongestTargetRoute)
        return false;
    TargetLayout there = targetLayout(world, state, order.target);
    there.route = order.points;
    if (!isSound(there)) return false;
    TargetState& target = state.targets[order.target];
    resumeOwn(target);
    target.orderedRoute = order.points;
    return true;
}

}  // namespace sagara::core
