#include "core/seakeeping/Hydrostatics.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {

double alongStations(const std::vector<double>& x_m, const std::vector<double>& values, int power,
                     double origin_m) {
    double sum = 0.0;
    for (std::size_t i = 1; i < x_m.size(); ++i) {
        const double dx_m = x_m[i] - x_m[i - 1], middle_m = 0.5 * (x_m[i] + x_m[i - 1]) - origin_m;
        const double mean = 0.5 * (values[i] + values[i - 1]);
        for (const double side : {-1.0, 0.0, 1.0}) {  // Simpson's rule: exact up to the third power
            const double at = middle_m + 0.5 * side * dx_m;
            const double value = mean + 0.5 * side * (values[i] - values[i - 1]);
            sum += (side == 0.0 ? 4.0 : 1.0) / 6.0 * dx_m * value * std::pow(at, power);
        }
    }
    return sum;
}

Hydrostatics hydrostaticsOf(const std::vector<HullStation>& stations, double draught_m) {
    std::vector<double> x_m, breadth_m, area_m2, moment_m3, inertia_m3;
    double midship_m2 = 0.0, widest_m = 0.0;
    for (const HullStation& s : stations) {
        x_m.push_back(s.x_m);
        breadth_m.push_back(s.breadth_m);
        area_m2.push_back(s.area_m2);
        moment_m3.push_back(s.area_m2 * s.centroid_m);
        inertia_m3.push_back(std::pow(s.breadth_m, 3) / 12.0);
        midship_m2 = std::max(midship_m2, s.area_m2);
        widest_m = std::max(widest_m, s.breadth_m);
    }
    Hydrostatics h;
    h.volume_m3 = alongStations(x_m, area_m2, 0);
    h.buoyancyForward_m = alongStations(x_m, area_m2, 1) / h.volume_m3;
    h.buoyancyHeight_m = alongStations(x_m, moment_m3, 0) / h.volume_m3;
    h.waterplane_m2 = alongStations(x_m, breadth_m, 0);
    h.flotationForward_m = alongStations(x_m, breadth_m, 1) / h.waterplane_m2;
    h.transverseInertia_m4 = alongStations(x_m, inertia_m3, 0);
    h.longitudinalInertia_m4 = alongStations(x_m, breadth_m, 2, h.flotationForward_m);
    h.transverseBM_m = h.transverseInertia_m4 / h.volume_m3;
    h.longitudinalBM_m = h.longitudinalInertia_m4 / h.volume_m3;
    h.midshipCoefficient = midship_m2 / (widest_m * draught_m);
    return h;
}

Hydrostatics hydrostaticsOf(const HullForm& form) {
    Hydrostatics h = hydrostaticsOf(form.stations, form.draught_m);
    const double lever_m = h.buoyancyHeight_m - form.gravityHeight_m;
    h.displacement_kg = form.waterDensity_kgpm3 * h.volume_m3;
    h.transverseGM_m = h.transverseBM_m + lever_m;
    h.longitudinalGM_m = h.longitudinalBM_m + lever_m;
    const double rectangle_m2 = form.lengthBp_m * form.breadth_m;
    h.blockCoefficient = h.volume_m3 / (rectangle_m2 * form.draught_m);
    h.waterplaneCoefficient = h.waterplane_m2 / rectangle_m2;
    return h;
}

}  // namespace sagara::core
