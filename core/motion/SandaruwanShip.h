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
    PlanarAcceleration acceleration(const ShipMotion& m, const Actuators& actuators,
                                    const Load& external) const;
    double swayAddedMass_kg() const { return m_model.swayAddedMassRatio * m_hull.mass_kg(); }

private:
    SandaruwanModel m_model;
    Hull m_hull;
    Propulsion m_propulsion;
};

}  // namespace sagara::core
