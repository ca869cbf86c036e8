#include "core/vessel/Metacentre.h"

namespace sagara::core {

double gravityDepth_m(const Hull& hull) {
    const double Cw = hull.waterplaneCoefficient, Cb = hull.blockCoefficient();
    const double KB_m = hull.draught_m * (5.0 / 6.0 - Cb / (3.0 * Cw));
    const double BM_m = (0.1216 * Cw - 0.0410) * hull.beam_m * hull.beam_m / (hull.draught_m * Cb);
    return hull.draught_m - (KB_m + BM_m - hull.metacentricHeight_m);
}

}  // namespace sagara::core
