#include "core/vessel/Metacentre.h"

namespace sagara::core {

double metacentre_m(double beam_m, double draught_m, double block, double waterplane) {
    const double KB_m = draught_m * (5.0 / 6.0 - block / (3.0 * waterplane));
    const double BM_m = (0.1216 * waterplane - 0.0410) * beam_m * beam_m / (draught_m * block);
    return KB_m + BM_m;
}

double metacentre_m(const Hull& hull) {
    return metacentre_m(hull.beam_m, hull.draught_m, hull.blockCoefficient(), hull.waterplaneCoefficient);
}

double gravityDepth_m(const Hull& hull) {
    return hull.draught_m - (metacentre_m(hull) - hull.metacentricHeight_m);
}

}  // namespace sagara::core
