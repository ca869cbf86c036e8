#include "core/world/LocalWaves.h"

#include <algorithm>
#include <cmath>

#include "core/sea/Nearshore.h"

namespace sagara::core {

LocalWaves::LocalWaves(const Area& area, const std::vector<SeaSystem>& sea, double tide_m)
    : m_area(&area), m_tide_m(tide_m) {
    double energy = 0.0, highest = 0.0;
    for (const SeaSystem& s : sea) {
        energy += s.significantHeight_m * s.significantHeight_m;
        if (s.significantHeight_m <= highest) continue;
        highest = s.significantHeight_m;
        m_peakPeriod_s = s.peakPeriod_s;
    }
    m_significantHeight_m = std::sqrt(energy);
}

LocalWaves::OfDepth LocalWaves::ofDepth(double charted_m) const {
    if (!m_area->shoaling || m_significantHeight_m <= 0.0) return {};
    const double depth_m = charted_m + m_tide_m;
    return {shoalingCoefficient(m_peakPeriod_s, m_area->waveDepth_m, depth_m),
            breakingHeight_m(m_peakPeriod_s, depth_m)};
}

double LocalWaves::factor(double shelter, const OfDepth& depth) const {
    const double arriving_m = shelter * m_significantHeight_m;
    const double carried = arriving_m > 0.0 ? depth.breaking_m / arriving_m : depth.shoaling;
    return shelter * std::min({depth.shoaling, carried, kMostFactor});
}

}  // namespace sagara::core
