#include "ui/chart/Graticule.h"

#include <array>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::chart {
namespace {

/// All values that are multiples of the step between two angles.
std::vector<double> multiples(double low_deg, double high_deg, double step_deg) {
    std::vector<double> values;
    for (double k = std::ceil(low_deg / step_deg); k * step_deg <= high_deg && values.size() < 100; ++k) {
        values.push_back(k * step_deg);
    }
    return values;
}

}  // namespace

double graticuleStep_min(double least_m) {
    constexpr std::array<double, 14> kSteps_min{0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 20, 30, 60};
    for (const double step : kSteps_min) {
        if (step * core::kNauticalMile_m >= least_m) return step;
    }
    return kSteps_min.back();
}

std::vector<GridLine> parallels(const core::LocalFrame& frame, const Extent& shown, double step_min) {
    const core::GeoPoint sw = frame.toGeo(shown.southWest), ne = frame.toGeo(shown.northEast);
    std::vector<GridLine> lines;
    for (const double lat : multiples(sw.lat_deg, ne.lat_deg, step_min / 60.0)) {
        lines.push_back({lat, frame.toLocal({lat, sw.lon_deg}), frame.toLocal({lat, ne.lon_deg})});
    }
    return lines;
}

std::vector<GridLine> meridians(const core::LocalFrame& frame, const Extent& shown, double step_min) {
    const core::GeoPoint sw = frame.toGeo(shown.southWest), ne = frame.toGeo(shown.northEast);
    std::vector<GridLine> lines;
    for (const double lon : multiples(sw.lon_deg, ne.lon_deg, step_min / 60.0)) {
        lines.push_back({lon, frame.toLocal({sw.lat_deg, lon}), frame.toLocal({ne.lat_deg, lon})});
    }
    return lines;
}

}  // namespace sagara::chart
