#include "render/link/Interpolate.h"

#include <algorithm>
#include <cassert>

#include "core/base/Angle.h"

namespace sagara::link {
namespace {

double mix(double a, double b, double f) { return a + f * (b - a); }
double mixAngle(double a_rad, double b_rad, double f) { return a_rad + f * core::wrapPi(b_rad - a_rad); }
core::NorthEast mix(core::NorthEast a, core::NorthEast b, double f) { return a + f * (b - a); }

constexpr double kFastest_mps = 200.0;
bool jumped(core::NorthEast a, core::NorthEast b, double span_s) {
    return core::distance(a, b) > kFastest_mps * span_s;
}

core::ShipMotion mix(const core::ShipMotion& a, const core::ShipMotion& b, double f) {
    core::ShipMotion m = (1.0 - f) * a + f * b;
    m.north_m = mix(a.north_m, b.north_m, f);
    m.east_m = mix(a.east_m, b.east_m, f);
    m.roll_rad = mixAngle(a.roll_rad, b.roll_rad, f);
    m.heading_rad = mixAngle(a.heading_rad, b.heading_rad, f);
    return m;
}

core::LineState mix(const core::LineState& a, const core::LineState& b, double f) {
    if (a.onBollard() != b.onBollard()) return b;  // made fast or cast off in between
    return {b.status, mix(a.length_m, b.length_m, f), mix(a.tension_N, b.tension_N, f)};
}

core::AnchorState mix(const core::AnchorState& a, const core::AnchorState& b, double f) {
    core::AnchorState m = b;
    if (a.status == core::AnchorStatus::Home || b.status == core::AnchorStatus::CableParted) return m;
    m.cableOut_m = mix(a.cableOut_m, b.cableOut_m, f);
    if (a.onBottom && b.onBottom) m.position = mix(a.position, b.position, f);
    return m;
}

core::OwnShipView mix(const core::OwnShipView& a, const core::OwnShipView& b, double f, double span_s) {
    core::OwnShipView v = b;
    if (jumped(a.motion.position(), b.motion.position(), span_s)) return v;
    v.motion = mix(a.motion, b.motion, f);
    v.overGround_mps = mix(a.overGround_mps, b.overGround_mps, f);
    v.rudder_rad = mix(a.rudder_rad, b.rudder_rad, f);
    for (std::size_t i = 0; i < std::min(a.shafts_rps.size(), b.shafts_rps.size()); ++i)
        v.shafts_rps[i] = mix(a.shafts_rps[i], b.shafts_rps[i], f);
    for (std::size_t i = 0; i < std::min(a.lines.size(), b.lines.size()); ++i)
        v.lines[i] = mix(a.lines[i], b.lines[i], f);
    for (std::size_t i = 0; i < std::min(a.anchors.size(), b.anchors.size()); ++i)
        v.anchors[i] = mix(a.anchors[i], b.anchors[i], f);
    return v;
}

core::TargetView mix(const core::TargetView& a, const core::TargetView& b, double f, double span_s) {
    core::TargetView v = b;
    if (jumped(a.position, b.position, span_s)) return v;
    v.position = mix(a.position, b.position, f);
    v.down_m = mix(a.down_m, b.down_m, f);
    v.roll_rad = mixAngle(a.roll_rad, b.roll_rad, f);
    v.pitch_rad = mix(a.pitch_rad, b.pitch_rad, f);
    v.heading_rad = mixAngle(a.heading_rad, b.heading_rad, f);
    v.speed_mps = mix(a.speed_mps, b.speed_mps, f);
    v.yawRate_radps = mix(a.yawRate_radps, b.yawRate_radps, f);
    return v;
}

}  // namespace

core::Snapshot interpolated(const core::Snapshot& a, const core::Snapshot& b, core::SimTime time) {
    if (b.tick <= a.tick || time >= b.time()) return b;
    if (time <= a.time()) return a;
    const double span_s = (b.time().seconds() - a.time().seconds());
    const double f =
        static_cast<double>(time.us - a.time().us) / static_cast<double>(b.time().us - a.time().us);
    core::Snapshot s = b;
    for (std::size_t i = 0; i < std::min(a.ships.size(), b.ships.size()); ++i)
        s.ships[i] = mix(a.ships[i], b.ships[i], f, span_s);
    for (core::TargetView& target : s.targets) {
        const auto before = std::find_if(a.targets.begin(), a.targets.end(),
                                         [&](const core::TargetView& t) { return t.index == target.index; });
        if (before != a.targets.end()) target = mix(*before, target, f, span_s);
    }
    s.weather = core::mixed(a.weather, b.weather, f);
    s.wind.speed_mps = mix(a.wind.speed_mps, b.wind.speed_mps, f);
    s.wind.windFrom_rad = mixAngle(a.wind.windFrom_rad, b.wind.windFrom_rad, f);
    s.tide_m = mix(a.tide_m, b.tide_m, f);
    return s;
}

void SnapshotTrail::add(std::shared_ptr<const core::Snapshot> snapshot) {
    if (!m_trail.empty() && snapshot->tick <= m_trail.back()->tick) m_trail.clear();
    m_trail.push_back(std::move(snapshot));
    if (m_trail.size() > kLongest) m_trail.pop_front();
}

core::Snapshot SnapshotTrail::at(core::SimTime time) const {
    assert(!m_trail.empty());
    const auto later = std::find_if(m_trail.begin(), m_trail.end(),
                                    [&](const auto& snapshot) { return snapshot->time() >= time; });
    if (later == m_trail.begin()) return *m_trail.front();
    if (later == m_trail.end()) return *m_trail.back();
    return interpolated(**(later - 1), **later, time);
}

}  // namespace sagara::link
