#pragma once

#include <optional>

#include "core/vessel/Vessel.h"

namespace sagara::core {

/// The same vessel without cargo, upright, trimmed so that propeller and rudder stay below the water. Draught
/// 2 m + 0.02 L (MARPOL, annex I, regulation 18), between 0.55 and 0.9 of the loaded draught; displacement by
/// its power Cwp / Cb of the draught (Normand); her MMG models, with linear derivatives and added masses
/// changed as the regressions of Clarke, Gedling and Hine (1983) change, and resistance with the wetted
/// surface of Denny and Mumford. Other published sets hold for the loading they were made for: a vessel
/// without an MMG model has none. Its groups are marked as estimated.
std::optional<Vessel> inBallast(const Vessel& loaded);

}  // namespace sagara::core
