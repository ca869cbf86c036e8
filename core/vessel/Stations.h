#pragma once

#include <vector>

#include "core/base/Config.h"

namespace sagara::core {

/// One section of the hull at the draught described, as strip theory wants it. A row of "stations" in the
/// document: [x_m, breadth_m, draught_m, area_m2, centroid_m], from aft forward.
struct HullStation {
    double x_m = 0.0;         ///< forward of midship
    double breadth_m = 0.0;   ///< on the waterline; nothing where only a bulb is there
    double draught_m = 0.0;   ///< keel of the section below the waterline
    double area_m2 = 0.0;     ///< immersed, both sides
    double centroid_m = 0.0;  ///< of the area above the baseline
};

/// The optional member "stations"; none where it is absent. `length_m` overall and `beam_m` bound them.
std::vector<HullStation> readStations(config::Reader& in, double length_m, double beam_m);

}  // namespace sagara::core
