#pragma once

#include "core/motion/PolynomialShip.h"

namespace sagara::core {

/// A ship that turns and drifts by transfer functions: Nomoto, Barauskis, Ueng, and the founding paper with
/// its audit's corrections (see TransferModel). K ~ U and tau, tau_v ~ 1/U when the document says so. Loads
/// that these models did not know (wind, lines, cross flow near rest) act on the mass and inertia of the ship
/// with their added parts.
class TransferShip {
public:
    TransferShip(const TransferModel& model, const Vessel& vessel);
    /// roll_radps2 is 0: the model has no roll, see ShipDynamics.
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
        double gain_perS;
        double yaw_s;     ///< tau
        double sway_s;    ///< tau_v
        double cubic_s2;  ///< n3
        double nearRest;  ///< share of cross flow, which stands in for dampings that fade with speed
    };
    double thrust_N(double surge_mps, const Actuators& actuators) const;
    Pace paceAt(double surge_mps) const;
    double turningLoss_kg() const;  ///< what multiplies v r in surge, less the mass
    double surgeMass_kg() const { return m_hull.mass_kg() * (1.0 + m_model.surgeAddedMassRatio); }
    double swayMass_kg() const { return m_hull.mass_kg() * (1.0 + m_model.swayAddedMassRatio); }
    double yawInertia_kgm2() const {
        return m_hull.mass_kg() * m_hull.pitchGyradius_m * m_hull.pitchGyradius_m *
               (1.0 + m_model.yawAddedInertiaRatio);
    }

    TransferModel m_model;
    Hull m_hull;
    std::vector<Propeller> m_propellers;
};

}  // namespace sagara::core
