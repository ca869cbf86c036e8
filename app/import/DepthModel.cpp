#include "app/import/DepthModel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sagara::importer {
namespace {

using core::NorthEast;
using core::Segment;

/// By rings of growing radius, because the index is quickest for small ones.
double nearest_m(const core::Shore& shore, NorthEast p) {
    constexpr double kFarthest_m = 200e3;
    for (double limit_m = 50.0; limit_m < kFarthest_m; limit_m *= 2.0) {
        const double found_m = shore.distance_m(p, limit_m);
        if (found_m < limit_m) return found_m;
    }
    return kFarthest_m;
}

double distanceToLine_m(const std::vector<NorthEast>& points, NorthEast p) {
    double best_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < points.size(); ++i) {
        best_m = std::min(best_m, distanceTo(Segment{points[i - 1], points[i]}, p));
    }
    return best_m;
}

}  // namespace

DepthModel::DepthModel(const DepthRules& rules, const LocalCoast& coast, const ElevationSource& elevation,
                       double landAtLeast_m, const core::LocalFrame& frame)
    : m_rules(rules), m_coast(coast), m_elevation(elevation), m_frame(frame), m_landAtLeast_m(landAtLeast_m) {
    for (const Sounding& sounding : rules.soundings) {
        const NorthEast at = frame.toLocal(sounding.at);
        const double excess = sounding.depth_m / profile_m(at) - 1.0;
        if (std::abs(excess) > rules.soundingTolerance) m_bends.push_back({at, excess});
    }
    for (const BedRules& bed : rules.beds) {
        Bed& made = m_beds.emplace_back(Bed{{}, &bed});
        for (const core::GeoPoint p : bed.points) made.points.push_back(frame.toLocal(p));
        if (!bed.isLine) made.points.push_back(made.points.front());
    }
}

double DepthModel::Bed::outside_m(NorthEast p) const {
    if (rules->isLine) return std::max(0.0, distanceToLine_m(points, p) - rules->halfWidth_m);
    return contains(points, p) ? 0.0 : distanceToLine_m(points, p);
}

double DepthModel::profile_m(NorthEast p) const {
    return m_rules.profileCoefficient * std::pow(nearest_m(m_coast.natural, p), m_rules.profileExponent);
}

/// Each sounding scales the bed about it. Soundings nearer to each other than twice the reach are not solved
/// together.
double DepthModel::bend(NorthEast p) const {
    double factor = 1.0;
    for (const Bend& b : m_bends) {
        const double r = distance(b.at, p) / m_rules.soundingReach_m;
        factor += b.excess * std::exp(-r * r);
    }
    return factor;
}

double DepthModel::waterDepth_m(NorthEast p) const {
    double depth_m = profile_m(p) * bend(p);
    for (const Bed& bed : m_beds) {
        const double eased_m = m_rules.sideSlope * bed.outside_m(p);
        if (bed.rules->atLeast_m) depth_m = std::max(depth_m, *bed.rules->atLeast_m - eased_m);
        if (bed.rules->atMost_m) depth_m = std::min(depth_m, *bed.rules->atMost_m + eased_m);
    }
    return depth_m;
}

double DepthModel::landDepth_m(NorthEast p) const {
    const double highest_m = std::max(m_landAtLeast_m, m_elevation.height_m(m_frame.toGeo(p)));
    return -std::min({profile_m(p), highest_m, m_rules.landAtMost_m});
}

bool DepthModel::isMadeGround(NorthEast p) const {
    double best_m = m_rules.worksReach_m;
    bool works = false;
    m_coast.shore.near(p, best_m, [&](const core::Shore::Piece& piece) {
        const double here_m = distanceTo(piece.segment, p);
        if (here_m >= best_m) return;
        best_m = here_m;
        works = isWorks(m_coast.shore.lines()[piece.line].kind);
    });
    return works;
}

std::vector<double> DepthModel::depths_m(const Raster& raster) const {
    const std::vector<char> land = nodesInside(raster, m_coast.land);
    std::vector<double> depths(raster.size());
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const NorthEast p = raster.node(i);
        depths[i] = land[i] && !isMadeGround(p) ? landDepth_m(p) : waterDepth_m(p);
    }
    return depths;
}

}  // namespace sagara::importer
