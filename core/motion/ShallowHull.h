#pragma once

#include "core/motion/Load.h"
#include "core/vessel/Hull.h"

namespace sagara::core {

/// What the ground adds to the force of the water on the hull (rudder and propeller not in it) for a model
/// that knows only deep water: the factors of MmgShallow.h less one, of resistance, of force and moment of
/// drift, and of the moment of turning. `deep`: her hull's force; `deepDrift`: the same without her yaw rate.
/// Whole from a depth of three draughts down, zero from six on; added masses stay those of deep water.
Load shallowHullLoad(const Hull& hull, const Load& deep, const Load& deepDrift, double surge_mps,
                     double depth_m);

}  // namespace sagara::core
