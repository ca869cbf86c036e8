#pragma once

#include "core/motion/Load.h"
#include "core/vessel/Hull.h"

namespace sagara::core {

/// How much larger than in deep water, as functions of the depth; 1 in deep water. Depths under 1.05 draughts
/// count as that.
struct ShallowFactors {
    double swayForce = 1.0;        ///< of drift: 1/(1-d/h)^n - d/h, n = 0.40 Cb B/d (Kijima and Nakiri)
    double yawMoment = 1.0;        ///< of drift: the same with n = 0.425 Cb B/d
    double surgeAddedMass = 1.0;   ///< Sheng (1981), Li and Wu (1990)
    double swayAddedMass = 1.0;    ///< the same
    double yawAddedInertia = 1.0;  ///< the same
};
ShallowFactors shallowFactors(const Hull& hull, double depth_m);

/// Resistance over that in deep water at the same speed, from Lackenby's (1963) loss of speed at the same
/// resistance, dV/V = 0.1242 (A/h^2 - 0.05) + 1 - sqrt(tanh(g h/V^2)), A the midship section, resistance
/// going with V^2. Subcritical; the loss is held at 60 %.
double shallowResistanceFactor(const Hull& hull, double speed_mps, double depth_m);

/// What the ground adds to the force of the water on the hull (rudder and propeller not in it) for a model
/// that knows only deep water. Zero from a depth of six draughts on; added masses stay those of deep water.
Load shallowHullLoad(const Hull& hull, const Load& deepHullForce, double surge_mps, double depth_m);

}  // namespace sagara::core
