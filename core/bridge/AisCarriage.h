#pragma once

#include "core/world/Target.h"

namespace sagara::core {

inline constexpr double kAisLength_m = 20.0;

/// Whether a ship sends AIS: all of 20 m and more, except who wants not to be seen. (SOLAS V/19 asks it of
/// 300 gross tonnage on international voyages and of passenger ships; many smaller ones carry it.)
inline bool carriesAis(const TargetLayout& layout) {
    return layout.length_m >= kAisLength_m && layout.behaviour != TargetBehaviour::Hostile;
}

}  // namespace sagara::core
