#pragma once

#include "core/base/Config.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {

/// What the numbers of a vessel's document say of each other: displacement, waterplane and stability against
/// the hull, weights against her size, machinery and deck gear against the places they can be in. Each number
/// is inside its own range already. Bounds are wide: what passes need not be good, what fails was mistyped.
/// What only shows when she moves is core/identify/TrialTrip.h.
void checkPlausible(config::Reader& document, const Vessel& vessel);

}  // namespace sagara::core
