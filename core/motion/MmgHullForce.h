#pragma once

#include "core/motion/Load.h"
#include "core/motion/ShipMotion.h"
#include "core/vessel/Hull.h"
#include "core/vessel/MmgModel.h"

namespace sagara::core {

/// How the water meets midship, in the MMG method's own quantities.
struct MmgFlow {
    double speed_mps = 0.0;  ///< U
    double drift_rad = 0.0;  ///< beta = atan2(-v, u), positive: flow from the port bow
    double v = 0.0;          ///< v / U
    double r = 0.0;          ///< r L / U
    /// 1 where the published derivatives hold, 0 where cross flow has taken over; depends on the direction of
    /// the motion and not on how fast it is.
    double published = 1.0;
};
MmgFlow mmgFlow(const MmgRange& range, double length_m, const ShipMotion& m);

/// Force of the water on the bare hull, X, Y, N about midship, without added masses. In the published range
/// the MMG polynomial (Yasukawa and Yoshimura 2015, eq 9; roll terms 2019). Outside it the unified form of
/// Yoshimura, Nakao and Ishibashi (2009), "Unified mathematical model for ocean and harbour manoeuvring",
/// MARSIM'09: linear terms with the surge velocity, cross-flow drag along the hull for the rest, any drift
/// angle, astern and at rest. MmgFlow::published blends the two.
Load mmgHullForce(const MmgParameters& model, const Hull& hull, const ShipMotion& m, const MmgFlow& flow);

}  // namespace sagara::core
