#pragma once

#include "core/motion/PolynomialShip.h"

namespace sagara::core {

/// The founding paper's three equations, corrected (its audit says what was wrong and why):
///   (M - Xudot) u' = (1 - t) T - X_uu u|u| + (M + X_vr) v r      (eq 3)
///   tau r' + r     = K delta                                    (eq 4)
///   tau_v v' + v   = K_v (tau r' + r)                            (eq 5), K_v negative
/// with K ~ U and tau, tau_v ~ 1/U when the document says so. Loads the paper did not know (wind, waves,
/// lines, cross flow near rest) act on the mass and inertia of the ship with their added parts.
class SandaruwanShip {
public:
    SandaruwanShip(const SandaruwanModel& model, const Vessel& vessel);
    /// roll_radps2 is 0: the model has no roll, see VerticalMotion.
    PlanarAcceleration acceleration(const ShipMotion& m, const Actuators& actuators, const Load& external,
                                    double depth_m = kDeepWater_m) const;
    /// Of yaw and sway the model knows only what they do: their forces are these accelerations times mass and
    /// inertia with their added parts.
    HullForces hullForces(const ShipMotion& m, const Actuators& actuators, double depth_m) const;
    Load forceFor(const ShipMotion& m, const ShipMotion& rate, double depth_m) const;  ///< see ShipDynamics
    bool ownsRoll() const { return false; }
    double swayAddedMass_kg() const { return m_model.swayAddedMassRatio * m_hull.mass_kg(); }

private:
    /// What changes with speed.
    struct Pace {
        double ratio;
        double gain_perS;
        double yaw_s;   ///< tau
        double sway_s;  ///< tau_v
        double nearRest;
    };
    double thrust_N(double surge_mps, const Actuators& actuators) const;
    Pace paceAt(double surge_mps) const;
    double swayMass_kg() const { return m_hull.mass_kg() * (1.0 + m_model.swayAddedMassRatio); }
    double yawInertia_kgm2() const {
        return m_hull.mass_kg() * m_hull.pitchGyradius_m * m_hull.pitchGyradius_m *
               (1.0 + m_model.yawAddedInertiaRatio);
    }

    SandaruwanModel m_model;
    Hull m_hull;
    std::vector<Propeller> m_propellers;
};

}  // namespace sagara::core
