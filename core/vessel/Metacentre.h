#pragma once

#include "core/vessel/Hull.h"

namespace sagara::core {

/// The transverse metacentre above the keel: KB by Morrish, BM of a waterplane whose inertia
/// is 0.1216 C_WP - 0.0410 of L B^3 (see estimate::Form).
double metacentre_m(double beam_m, double draught_m, double block, double waterplane);
double metacentre_m(const Hull& hull);

/// Centre of gravity below the waterline at which a hull has her metacentric height. Above the
/// waterline it is negative.
double gravityDepth_m(const Hull& hull);

}  // namespace sagara::core
