#pragma once

#include <vector>

#include "core/sea/Spectrum.h"
#include "core/world/Area.h"

namespace sagara::core {

/// The waves from place to place at one moment, as a factor on the heights of those of the open area:
/// shelter, and where the area says so shoaling and breaking by the depth (core/sea/Nearshore.h). One factor
/// serves all waves: that of the highest system's period and of the height of all together.
class LocalWaves {
public:
    static constexpr double kMostFactor = 2.0;  ///< of shoaling

    /// `area` must live as long. `tide_m`: above chart datum.
    LocalWaves(const Area& area, const std::vector<SeaSystem>& sea, double tide_m);

    double factorAt(NorthEast p) const {
        const double shelter = m_area->shelterFactor(p);
        return m_area->shoaling ? factor(shelter, ofDepth(m_area->depth_m(p))) : shelter;
    }

    /// The same in two steps, for many places.
    struct OfDepth {
        double shoaling = 1.0;    ///< factor on heights
        double breaking_m = 1e9;  ///< significant height that the depth carries
    };
    OfDepth ofDepth(double charted_m) const;
    double factor(double shelter, const OfDepth& depth) const;

    double significantHeight_m() const { return m_significantHeight_m; }
    double peakPeriod_s() const { return m_peakPeriod_s; }

private:
    const Area* m_area;
    double m_tide_m;
    double m_significantHeight_m = 0.0;
    double m_peakPeriod_s = 0.0;  ///< of the highest system
};

}  // namespace sagara::core
