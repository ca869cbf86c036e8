#pragma once

#include <array>
#include <vector>

#include "core/motion/Actuators.h"
#include "core/motion/Load.h"
#include "core/motion/Propeller.h"
#include "core/motion/ShipMotion.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {

/// Accelerations of the four degrees of freedom a manoeuvring model owns.
struct PlanarAcceleration {
    double surge_mps2 = 0.0;
    double sway_mps2 = 0.0;
    double roll_radps2 = 0.0;
    double yaw_radps2 = 0.0;
    double heel_Nm = 0.0;  ///< of the forces in the plane, where the model does not own roll
};

/// A published polynomial set at work: M nu' = F as in Perez and Blanke (2002), with an extension that lets
/// the ship start, stop, back and turn on the spot. The extension is exactly zero in the published range of
/// speed ahead with the shafts going ahead; below it fades in over holdsFrom .. extensionBelow:
///   thrust      constant at a shaft speed (published)   -> KT(J) of each shaft, ahead and astern
///   rudder      1/2 rho A CL (u^2 + v^2)    (published)  -> u|u| plus the race of the propeller before each
///   rudder cross flow  quadratic terms in v and r (published)  -> strips along the hull
/// The yaw moment of two shafts comes from their distance from the centreline, at any speed.
class PolynomialShip {
public:
    PolynomialShip(const PolynomialModel& model, const Vessel& vessel);

    PlanarAcceleration acceleration(const ShipMotion& m, const Actuators& actuators, const Load& external,
                                    double depth_m = kDeepWater_m) const;

    /// 1 where the published set holds, 0 where the extension has taken over.
    double publishedShare(double surge_mps) const;
    /// Forces of the hull, without inertia and without rudder and propellers.
    Load hullLoad(const ShipMotion& m) const;
    Load propulsionLoad(const ShipMotion& m, const Actuators& actuators) const;
    Load rudderLoad(const ShipMotion& m, const Actuators& actuators) const;
    HullForces hullForces(const ShipMotion& m, const Actuators& actuators, double /*depth_m*/) const {
        return {hullLoad(m), rudderLoad(m, actuators), propulsionLoad(m, actuators)};
    }
    Load forceFor(const ShipMotion& m, const ShipMotion& rate, double depth_m) const;  ///< see ShipDynamics
    bool ownsRoll() const { return true; }
    double swayAddedMass_kg() const { return -m_model.Yvdot; }

private:
    double thrust_N(std::size_t shaft, const Actuators& actuators, double surge_mps) const;

    PolynomialModel m_model;
    Hull m_hull;
    std::vector<Propeller> m_propellers;
    Steering m_steering;
    std::array<std::array<double, 3>, 3> m_inverseMass{};  ///< of sway, roll, yaw
};

}  // namespace sagara::core
