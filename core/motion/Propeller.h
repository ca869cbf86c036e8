#pragma once

#include <vector>

#include "core/motion/FourQuadrantSeries.h"
#include "core/motion/ShipMotion.h"
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
/// With open-water data (knowsTorque()): exactly KT(J) and KQ(J) ahead at the design pitch from J = 0 to
/// where the thrust ends; in all other quadrants and at other pitches the measured B4 series of the same
/// pitch and area (see fourQuadrants), drawn to the propeller's own values where the two meet: the difference
/// there fades over 40 degrees of the advance angle before, 30 behind. Label for people: series, not this
/// propeller.
///
/// Where the document knows KT ahead alone: rho n^2 D^4 KT(J), KT held at its value for J = -0.6 and J = 1.4
/// beyond these. Astern: bollard thrust times the unit's astern ratio, falling off with sternway by the same
/// chord; headway leaves it as it is, because the engine's torque then holds it. Stopped: nothing. Trend only
/// outside J 0 to 1; no torque.
class Propeller {
public:
    explicit Propeller(const PropulsionUnit& unit);

    /// `inflow_mps`: of the water along the shaft into the disc, positive from ahead: (1 - w) u.
    /// `pitch`: over the design pitch.
    PropellerForce force(double shaft_rps, double pitch, double inflow_mps, double density_kgpm3) const;
    /// The same with the ship's speed through the water ahead and the unit's own wake fraction.
    PropellerForce behindHull(double shaft_rps, double pitch, double surge_mps, double density_kgpm3) const {
        return force(shaft_rps, pitch, (1.0 - m_unit.wakeFraction) * surge_mps, density_kgpm3);
    }
    bool knowsTorque() const { return m_unit.openWater.has_value(); }
    const PropulsionUnit& unit() const { return m_unit; }

private:
    PropellerForce thrustAlone(double shaft_rps, double inflow_mps, double density_kgpm3) const;
    StarCoefficients star(double beta_rad, double pitch) const;
    StarCoefficients own(double beta_rad) const;
    StarCoefficients ownLessSeries(double beta_rad) const;

    PropulsionUnit m_unit;
    double m_end_rad = 0.0;  ///< advance angle up to which the propeller's own data hold
};

std::vector<Propeller> propellersOf(const Propulsion& propulsion);

/// Water into the disc of a drive that pushes towards an azimuth, with the ship's wake from ahead.
double inflowOf_mps(const PropulsionUnit& unit, const ShipMotion& m, double azimuth_rad);

/// Square of the velocity a working propeller adds in its race, m^2/s^2: 2 T / (rho A), 0 unless it drives
/// ahead (actuator disc, Rankine-Froude).
double addedRaceSquared(const PropulsionUnit& unit, double thrust_N, double density_kgpm3);

}  // namespace sagara::core
