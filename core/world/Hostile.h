#pragma once

#include "core/world/Target.h"

namespace sagara::core {

/// What a hostile craft wants this tick, given the own ship nearest to her. She loiters about her home,
/// her first waypoint or where the trainer has put her; once the own ship is within 1 M she closes; within
/// 400 m she harasses: runs round the ship at a stand-off, across her bow and down her side, never nearer
/// than 120 m on purpose; after four minutes she withdraws for three. The phase is in her state.
TargetIntent hostileIntent(const TargetLayout& layout, TargetState& state, NorthEast ownPosition,
                           double ownHeading_rad, double ownSpeed_mps, double dt_s);

}  // namespace sagara::core
