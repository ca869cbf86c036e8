#include "render/scene/Moment.h"

#include <algorithm>

#include "core/base/Angle.h"

namespace sagara::render {
namespace {

bool holdsOn(const core::AnchorState& anchor) { return anchor.onBottom && anchor.cableOut_m > 0.0; }

OwnShipPose poseOf(const core::OwnShipView& ship) {
    OwnShipPose p;
    p.position = ship.motion.position();
    p.down_m = ship.motion.down_m;
    p.roll_rad = ship.motion.roll_rad;
    p.pitch_rad = ship.motion.pitch_rad;
    p.heading_rad = ship.motion.heading_rad;
    p.speedThroughWater_mps = ship.motion.surge_mps;
    p.yawRate_radps = ship.motion.yawRate_radps;
    p.rudder_rad = ship.rudder_rad;
    p.anchored = std::any_of(ship.anchors.begin(), ship.anchors.end(), holdsOn);
    p.moored = std::any_of(ship.lines.begin(), ship.lines.end(),
                           [](const core::LineState& line) { return line.onBollard(); });
    return p;
}

TargetPose poseOf(const core::TargetView& target) {
    TargetPose p;
    p.position = target.position;
    p.down_m = target.down_m;
    p.roll_rad = target.roll_rad;
    p.pitch_rad = target.pitch_rad;
    p.heading_rad = target.heading_rad;
    p.speedThroughWater_mps = target.speed_mps;
    p.yawRate_radps = target.yawRate_radps;
    p.index = target.index;
    return p;
}

double mix(double a, double b, double f) { return a + (b - a) * f; }
double mixAngle(double a, double b, double f) { return a + core::wrapPi(b - a) * f; }

void mixInto(ShipPose& a, const ShipPose& b, double f) {
    a.position = a.position + f * (b.position - a.position);
    a.down_m = mix(a.down_m, b.down_m, f);
    a.roll_rad = mix(a.roll_rad, b.roll_rad, f);
    a.pitch_rad = mix(a.pitch_rad, b.pitch_rad, f);
    a.heading_rad = mixAngle(a.heading_rad, b.heading_rad, f);
    a.speedThroughWater_mps = mix(a.speedThroughWater_mps, b.speedThroughWater_mps, f);
    a.yawRate_radps = mix(a.yawRate_radps, b.yawRate_radps, f);
}

}  // namespace

Moment momentOf(const core::Snapshot& snapshot) {
    Moment m;
    m.time = snapshot.time();
    for (const core::OwnShipView& ship : snapshot.ships) m.ships.push_back(poseOf(ship));
    for (const core::TargetView& target : snapshot.targets) m.targets.push_back(poseOf(target));
    m.weather = snapshot.weather;
    m.wind = snapshot.wind;
    m.sea = snapshot.sea;
    m.tide_m = snapshot.tide_m;
    return m;
}

Moment between(const core::Snapshot& a, const core::Snapshot& b, core::SimTime time) {
    Moment m = momentOf(a);
    m.time = time;
    const double span_us = static_cast<double>(b.time().us - a.time().us);
    if (span_us <= 0.0) return m;
    const double f = std::clamp(static_cast<double>(time.us - a.time().us) / span_us, -1.0, 2.0);
    for (std::size_t i = 0; i < std::min(m.ships.size(), b.ships.size()); ++i)
        mixInto(m.ships[i], poseOf(b.ships[i]), f);
    for (TargetPose& target : m.targets) {
        const auto later = std::find_if(b.targets.begin(), b.targets.end(),
                                        [&](const core::TargetView& t) { return t.index == target.index; });
        if (later != b.targets.end()) mixInto(target, poseOf(*later), f);
    }
    m.tide_m = mix(a.tide_m, b.tide_m, f);
    return m;
}

}  // namespace sagara::render
