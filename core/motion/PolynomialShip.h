#pragma once

#include <array>
#include <vector>

#include "core/motion/Actuators.h"
#include "core/motion/Load.h"
#include "core/motion/PolynomialRows.h"
#include "core/motion/Propeller.h"
#include "core/motion/ShipMotion.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {

/// Where the side force on a hull acts, over the draught below the waterline.
inline constexpr double kLateralForceDepth = 0.35;

/// Accelerations of the four degrees of freedom a manoeuvring model owns.
struct PlanarAcceleration {
    double surge_mps2 = 0.0;
    double sway_mps2 = 0.0;
    double roll_radps2 = 0.0;
    double yaw_radps2 = 0.0;
    /// Where the model does not own roll: of the forces in the plane about the height of the centre of
    /// gravity, and about Bo without what added mass makes of the acceleration.
    double heel_Nm = 0.0;
    double heelAtBo_Nm = 0.0;
};

/// A published polynomial set at work, M nu' = F: hull rows, and rudder and propellers by the rule the set
/// was published with, or as rows.
///
/// Sets with the rule of Perez and Blanke (2002) (LiftDrive) carry an extension that lets the ship start,
/// stop, back and turn on the spot. It is exactly zero in the published range of speed ahead with the shafts
/// going ahead; below it fades in over holdsFrom .. extensionBelow:
///   thrust      constant at a shaft speed (published)   -> KT(J) of each shaft, ahead and astern
///   rudder      1/2 rho A CL (u^2 + v^2)    (published)  -> u|u| plus the race of the propeller before each
///   rudder cross flow  quadratic terms in v and r (published)  -> strips along the hull
/// The yaw moment of two shafts comes from their distance from the centreline, at any speed.
class PolynomialShip {
public:
    PolynomialShip(const PolynomialModel& model, const Vessel& vessel);

    PlanarAcceleration acceleration(const ShipMotion& m, const Actuators& actuators, const Load& external,
                                    double depth_m = kDeepWater_m) const;
    /// Without inertia; the rows may hold what comes of the turning of frame B.
    HullForces hullForces(const ShipMotion& m, const Actuators& actuators,
                          double depth_m = kDeepWater_m) const;
    Load forceFor(const ShipMotion& m, const ShipMotion& rate, double depth_m) const;  ///< see ShipDynamics
    bool ownsRoll() const { return m_model.Ixx.has_value(); }
    double swayAddedMass_kg() const { return -m_model.Yvdot * m_mass_kg; }

    /// Of a LiftDrive: 1 where the published rule holds, 0 where the extension has taken over.
    double publishedShare(double surge_mps) const;

private:
    /// Mass and added mass, SI, at a depth parameter.
    struct Inertia {
        double surge_kg;
        std::array<std::array<double, 3>, 3> lateral;  ///< of sway, roll, yaw
        std::array<std::array<double, 3>, 3> inverse;
    };
    Inertia inertiaAt(double depthParameter) const;
    Inertia inertiaIn(double depth_m) const {
        const double z = m_rows.depthParameter(depth_m);
        return z == 0.0 ? m_deepWater : inertiaAt(z);
    }
    /// What comes of the turning of frame B, where the rows do not hold it.
    Load turningLoad(const ShipMotion& m) const;
    double thrust_N(std::size_t shaft, const Actuators& actuators, double surge_mps) const;
    Load propulsionLoad(const ShipMotion& m, const Actuators& actuators) const;
    Load balancedLoad(const ShipMotion& m, const Actuators& actuators) const;
    Load rudderLoad(const ShipMotion& m, const Actuators& actuators) const;

    PolynomialModel m_model;
    Hull m_hull;
    std::vector<Propeller> m_propellers;
    Steering m_steering;
    PolynomialRows m_rows;
    double m_mass_kg, m_firstMoment_kgm, m_inertia_kgm2;  ///< one unit of the set
    Inertia m_deepWater;
};

}  // namespace sagara::core
