#include "core/bridge/ShipOrders.h"

#include <algorithm>

namespace sagara::core {
namespace {

template <typename Do>
void forShafts(const OwnShip& ship, OwnShipState& state, std::uint8_t shaft, Do&& act) {
    for (std::size_t i = 0; i < ship.shaftCount(); ++i) {
        if (shaft == kAllShafts || shaft == i) act(state.shafts[i]);
    }
}

void moveLever(ShaftState& shaft, double order_rps) {
    shaft.order_rps = order_rps;
    shaft.pitchByHand = false;
}

}  // namespace

void obey(const OwnShip& ship, OwnShipState& state, const HelmOrder& order) {
    const double limit_rad = ship.vessel.steering.limit_rad;
    state.steering.order_rad = std::clamp(order.rudder_rad, -limit_rad, limit_rad);
    state.autopilot.mode = AutopilotMode::Off;  // a hand on the wheel takes over
}

void obey(const OwnShip& ship, OwnShipState& state, const TelegraphOrder& order) {
    const auto step = static_cast<std::size_t>(order.step);
    if (step >= kTelegraphSteps) return;
    const double speed_rps = ship.vessel.propulsion.telegraph_rps[step];
    forShafts(ship, state, order.shaft, [&](ShaftState& shaft) { moveLever(shaft, speed_rps); });
}

void obey(const OwnShip& ship, OwnShipState& state, const ShaftOrder& order) {
    const TelegraphTable& table = ship.vessel.propulsion.telegraph_rps;
    const double most = 1.1 * table.back(),
                 least = 1.1 * table.front();  // a lever goes a little beyond the steps
    forShafts(ship, state, order.shaft,
              [&](ShaftState& shaft) { moveLever(shaft, std::clamp(order.speed_rps, least, most)); });
}

void obey(const OwnShip& ship, OwnShipState& state, const PitchOrder& order) {
    forShafts(ship, state, order.shaft, [&](ShaftState& shaft) {
        shaft.pitchOrder = order.pitch;
        shaft.pitchByHand = true;
    });
}

void obey(const OwnShip& ship, OwnShipState& state, const AzimuthOrder& order) {
    forShafts(ship, state, order.shaft, [&](ShaftState& shaft) { shaft.azimuthOrder_rad = order.angle_rad; });
}

void obey(const OwnShip& ship, OwnShipState& state, const ThrusterOrder& order) {
    if (order.thruster >= ship.thrusterCount()) return;
    state.thrusters[order.thruster].order = std::clamp(order.share, -1.0, 1.0);
}

void obey(const OwnShip&, OwnShipState& state, const AutopilotOrder& order) {
    state.autopilot.mode = order.mode;
    state.autopilot.setHeading_rad = order.heading_rad;
    state.autopilot.along_m = kSomewhere_m;
    state.autopilot.offTrackSum_ms = 0.0;
}

void obey(const OwnShip&, OwnShipState& state, const PilotOrder& order) {
    if (order.engage == state.pilot.engaged) return;
    state.pilot.engaged = order.engage;  // he goes on with the step that he left
    state.autopilot.along_m = kSomewhere_m;
    state.pilot.since_s = 0.0;
    if (!order.engage) state.autopilot.mode = AutopilotMode::Off;
}

void obey(const OwnShip& ship, OwnShipState& state, const LineOrder& order) {
    if (order.line >= ship.lines.size()) return;
    LineState& line = state.lines[order.line];
    if (!line.onBollard()) return;
    switch (order.action) {
        case LineAction::Hold:
            line.status = LineStatus::Fast;
            break;
        case LineAction::Slack:
            line.status = LineStatus::Slacking;
            break;
        case LineAction::Heave:
            line.status = LineStatus::Heaving;
            break;
        case LineAction::LetGo:
            line.status = LineStatus::CastOff;
            break;
    }
}

void obey(const OwnShip& ship, OwnShipState& state, const AnchorOrder& order) {
    if (order.anchor >= ship.anchorCount()) return;
    AnchorState& anchor = state.anchors[order.anchor];
    if (anchor.status == AnchorStatus::CableParted) return;
    const double longest_m = ship.vessel.groundTackle.anchors[order.anchor].cableLength_m;
    const double wanted_m = std::clamp(order.cable_m, 0.0, longest_m);
    const bool home = anchor.status == AnchorStatus::Home;
    switch (order.action) {
        case AnchorAction::LetGo:
            if (!home) return;
            anchor.status = AnchorStatus::Running;
            break;
        case AnchorAction::Veer:
            if (home || wanted_m <= anchor.cableOut_m) return;
            anchor.status = AnchorStatus::Veering;
            break;
        case AnchorAction::Hold:
            if (!home) anchor.status = AnchorStatus::Held;
            return;
        case AnchorAction::HeaveIn:
            if (home || wanted_m >= anchor.cableOut_m) return;
            anchor.status = AnchorStatus::Heaving;
            break;
    }
    anchor.stopAt_m = wanted_m;
}

}  // namespace sagara::core
