#include "core/seakeeping/SectionPanels.h"

#include <cmath>

namespace sagara::core {

std::vector<SectionPanel> panelsOf(const std::vector<SectionPoint>& nodes) {
    std::vector<SectionPanel> panels;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const SectionPoint a = nodes[i - 1], b = nodes[i];
        const double dy_m = b.y_m - a.y_m, dz_m = b.z_m - a.z_m;
        const double length_m = std::hypot(dy_m, dz_m);
        if (length_m <= 0.0) continue;
        panels.push_back({a,
                          b,
                          {0.5 * (a.y_m + b.y_m), 0.5 * (a.z_m + b.z_m)},
                          length_m,
                          dz_m / length_m,
                          -dy_m / length_m});
    }
    return panels;
}

SectionArea areaOf(const std::vector<SectionPanel>& panels) {
    SectionArea total;
    double moment_m3 = 0.0;
    for (const SectionPanel& p : panels) {
        const double dz_m = p.to.z_m - p.from.z_m;
        total.area_m2 += 2.0 * p.middle.y_m * dz_m;
        // Integral of 2 y z dz over a straight piece.
        moment_m3 += dz_m / 3.0 *
                     (p.from.y_m * (2.0 * p.from.z_m + p.to.z_m) + p.to.y_m * (p.from.z_m + 2.0 * p.to.z_m));
    }
    if (total.area_m2 > 0.0) total.depth_m = -moment_m3 / total.area_m2;
    return total;
}

}  // namespace sagara::core
