#pragma once

#include "core/vessel/Machinery.h"

namespace sagara::core {

/// Thrust of one propeller on the water (deduction not applied), ahead positive, and the torque that its
/// shaft has to give it, positive when the water holds back a shaft that turns ahead.
struct PropellerForce {
    double thrust_N = 0.0;
    double torque_Nm = 0.0;
};

/// One propeller of a vessel document at work, for any shaft speed, pitch and inflow. Immutable.
///
/// Where the document knows thrust alone (knowsTorque() false): ahead rho n^2 D^4 KT(J), KT held at its value
/// for J = -0.6 and J = 1.4 beyond these. Astern: bollard thrust times the unit's astern ratio, falling off
/// with sternway by the same chord; headway leaves it as it is, because the engine's torque then holds it.
/// Stopped: nothing. Trend only outside J 0 to 1.
class Propeller {
public:
    explicit Propeller(const PropulsionUnit& unit) : m_unit(unit) {}

    /// `inflow_mps`: of the water along the shaft into the disc, positive from ahead: (1 - w) u.
    /// `pitch`: over the design pitch.
    PropellerForce force(double shaft_rps, double pitch, double inflow_mps, double density_kgpm3) const;
    /// The same with the ship's speed through the water ahead and the unit's own wake fraction.
    PropellerForce behindHull(double shaft_rps, double pitch, double surge_mps, double density_kgpm3) const {
        return force(shaft_rps, pitch, (1.0 - m_unit.wakeFraction) * surge_mps, density_kgpm3);
    }
    bool knowsTorque() const { return false; }
    const PropulsionUnit& unit() const { return m_unit; }

private:
    PropulsionUnit m_unit;
};

std::vector<Propeller> propellersOf(const Propulsion& propulsion);

/// Square of the velocity a working propeller adds in its race, m^2/s^2: 2 T / (rho A), 0 unless it drives
/// ahead (actuator disc, Rankine-Froude).
double addedRaceSquared(const PropulsionUnit& unit, double thrust_N, double density_kgpm3);

}  // namespace sagara::core
