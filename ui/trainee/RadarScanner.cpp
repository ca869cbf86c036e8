#include "ui/trainee/RadarScanner.h"

#include <cmath>

namespace sagara::ui::console {
namespace {

constexpr double kStepsPerSecond = static_cast<double>(core::RadarPicture::kAzimuths) / core::kRadarTurn_s;

}  // namespace

RadarScanner::RadarScanner(const core::World& world, std::size_t ship)
    : m_world(world), m_ship(ship), m_coast(world.area), m_set(core::radarOf(world.ships[ship]->vessel)) {
    for (const core::Mark& mark : world.area.marks) m_marks.push_back(core::radarObjectOf(mark));
    setRange(1.5 * core::kNauticalMile_m);
}

void RadarScanner::setRange(double range_m) {
    m_picture.clear(range_m);
    m_fresh = true;
}

std::vector<core::RadarObject> RadarScanner::objectsNow(const core::Snapshot& now) const {
    std::vector<core::RadarObject> objects = m_marks;
    for (const core::TargetView& t : now.targets)
        objects.push_back(
            core::radarObjectOf(core::targetLayout(m_world, now.added, t.index), t.position, t.heading_rad));
    for (std::size_t i = 0; i < now.ships.size(); ++i) {
        if (i == m_ship) continue;
        const core::Hull& hull = m_world.ships[i]->vessel.hull;
        core::TargetLayout other;
        other.length_m = hull.lengthOverall_m;
        other.beam_m = hull.beam_m;
        objects.push_back(
            core::radarObjectOf(other, now.ships[i].motion.position(), now.ships[i].motion.heading_rad));
    }
    return objects;
}

void RadarScanner::advance(core::SimTime time, const core::Snapshot& now) {
    const core::ShipMotion& m = now.ships[m_ship].motion;
    m_antenna = core::HeadingFrame(m.position(), m.heading_rad).point(m_set.antenna);
    const double turned = time.seconds() * kStepsPerSecond;
    constexpr auto kAll = core::RadarPicture::kAzimuths;
    const double since = turned - m_swept;
    const bool whole = m_fresh || since < 0.0 || since >= static_cast<double>(kAll);
    const auto count = whole ? kAll : static_cast<std::size_t>(since);
    if (count == 0) return;
    m_swept = whole ? std::floor(turned) : m_swept + static_cast<double>(count);
    m_fresh = false;
    const auto end = static_cast<std::size_t>(std::llround(m_swept)) % kAll;
    const std::size_t first = (end + kAll - count % kAll) % kAll;
    const auto turn = static_cast<std::uint32_t>(m_swept / static_cast<double>(kAll));
    core::sweepRadar(m_coast, objectsNow(now), m_antenna, m_set, first, count, turn, m_picture);
    m_azimuth = end;
}

}  // namespace sagara::ui::console
