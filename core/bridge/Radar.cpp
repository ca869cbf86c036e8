#include "core/bridge/Radar.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {
namespace {

constexpr double kLight_mps = 299'792'458.0;
constexpr double kMastAboveEye_m = 4.0;

std::vector<RadarCoast::Edge> edgesOf(const std::vector<NorthEast>& points, bool closed) {
    std::vector<RadarCoast::Edge> edges;
    for (std::size_t i = 1; i < points.size(); ++i) edges.push_back({points[i - 1], points[i]});
    if (closed && points.size() > 2) edges.push_back({points.back(), points.front()});
    return edges;
}

}  // namespace

RadarSet radarOf(const Vessel& vessel) {
    RadarSet set;
    set.antenna = {vessel.bridgeEye.x_m, 0.0};
    set.antennaHeight_m = vessel.bridgeEyeHeight_m + kMastAboveEye_m;
    return set;
}

double radarEcho_m(double range_m) {
    const double pulse_s = range_m <= 0.75 * kNauticalMile_m  ? 0.07e-6
                           : range_m <= 3.0 * kNauticalMile_m ? 0.25e-6
                                                              : 0.7e-6;
    return 0.5 * kLight_mps * pulse_s;
}

double radarHorizon_m(double height_m) { return std::sqrt(2.0 * kRadarEarth_m * std::max(0.0, height_m)); }

double leastCrossSection_m2(double range_m) {
    const double ratio = range_m / (4.9 * kNauticalMile_m);
    return 10.0 * ratio * ratio * ratio * ratio;
}

RadarObject radarObjectOf(const TargetLayout& layout, NorthEast position, double heading_rad) {
    return {position,
            heading_rad,
            layout.length_m,
            layout.beam_m,
            1.5 + 0.12 * layout.length_m,
            0.02 * std::pow(layout.length_m, 2.5)};
}

RadarObject radarObjectOf(const Mark& mark) {
    const double light_m = mark.light ? mark.light->height_m : 0.0;
    RadarObject object{.position = mark.position, .height_m = 3.5, .crossSection_m2 = 10.0};
    if (mark.floating) return object;
    object.height_m = std::max(5.0, light_m);
    object.crossSection_m2 = mark.kind == MarkKind::Lighthouse ? 200.0 : 30.0;
    return object;
}

RadarCoast::RadarCoast(const Area& area) : m_area(area) {
    for (const auto* rings : {&area.land, &area.context})
        for (const auto& ring : *rings) {
            const auto edges = edgesOf(ring, true);
            m_rings.insert(m_rings.end(), edges.begin(), edges.end());
        }
    for (const ShoreLine& line : area.shore.lines()) {
        if (line.kind != ShoreKind::Breakwater && line.kind != ShoreKind::Jetty) continue;
        const auto edges = edgesOf(line.points, false);
        m_walls.insert(m_walls.end(), edges.begin(), edges.end());
    }
}

double RadarCoast::height_m(NorthEast p) const {
    for (const Grid& grid : m_area.elevation)
        if (grid.covers(p)) return std::max(kRadarBeach_m, grid.at(p));
    return kRadarBeach_m;
}

void RadarPicture::clear(double newRange_m) {
    range_m = newRange_m;
    std::fill(levels.begin(), levels.end(), std::uint8_t{0});
}

}  // namespace sagara::core
