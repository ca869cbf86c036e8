#pragma once

#include <string>
#include <vector>

#include "core/seakeeping/HullForm.h"

namespace sagara::core {

/// Upright at the draught described. x forward of midship, heights above the baseline.
struct Hydrostatics {
    double volume_m3 = 0.0;
    double displacement_kg = 0.0;    ///< of the water displaced
    double buoyancyForward_m = 0.0;  ///< LCB
    double buoyancyHeight_m = 0.0;   ///< KB
    double waterplane_m2 = 0.0;
    double flotationForward_m = 0.0;  ///< LCF
    double transverseInertia_m4 = 0.0;
    double longitudinalInertia_m4 = 0.0;  ///< of the waterplane about its centre
    double transverseBM_m = 0.0;
    double longitudinalBM_m = 0.0;
    double transverseGM_m = 0.0;
    double longitudinalGM_m = 0.0;
    double blockCoefficient = 0.0;
    double midshipCoefficient = 0.0;
    double waterplaneCoefficient = 0.0;
};

/// Stations joined by straight lines.
Hydrostatics hydrostaticsOf(const HullForm& form);

/// The same numbers from the stations alone, before mass and centre of gravity are known.
Hydrostatics hydrostaticsOf(const std::vector<HullStation>& stations, double draught_m);

/// Righting lever at fixed displacement, free to sink and not to trim. Up to the deck the sides go on as they
/// meet the waterline, at most 27 degrees from upright: no station says how they do.
struct RightingLever {
    double heel_rad = 0.0;
    double gz_m = 0.0;
};
std::vector<RightingLever> rightingLevers(const HullForm& form, const std::vector<double>& heels_rad);

/// `name,value` rows, with the GZ curve every 5 degrees to 60; notes as comments.
std::string hydrostaticsReport(const HullForm& form);

/// Integral over the length of values joined by straight lines, times (x - origin)^power, exactly.
double alongStations(const std::vector<double>& x_m, const std::vector<double>& values, int power,
                     double origin_m = 0.0);

}  // namespace sagara::core
