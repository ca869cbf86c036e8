#pragma once

#include <vector>

#include "core/vessel/Vessel.h"

namespace sagara::core {

/// Prismatic wedges on the plane: Savitsky (1964), Marine Technology 1(1), 71-95. Trim tau in degrees, wetted
/// length lambda as the mean of keel and chine over the beam of the chines b, speed C_V = V / sqrt(g b).
/// Holds for C_V 0.6 to 13, tau 2 to 15 deg, lambda up to 4.
struct PlaningLift {
    double dynamic;  ///< of the flat plate: what goes with the pressure of the flow
    double still;    ///< of the flat plate: what goes with the weight of the water
    double flat() const { return dynamic + still; }
};
PlaningLift planingLift(double speedCoefficient, double trim_deg, double wettedOverBeam);  ///< eq 15, C_L0
/// Of a wedge: less, by the deadrise, than of the flat plate; over 1/2 rho V^2 b^2 (eq 16). And back.
double wedgeLift(double flatLift, double deadrise_rad);
double flatLift(double wedgeLift, double deadrise_rad);
/// Centre of pressure forward of the transom, over b (eq 19).
double pressureCentre(double speedCoefficient, double wettedOverBeam);
/// Wetted length of the keel over b (eq 3).
double wettedKeel(double trim_rad, double wettedOverBeam, double deadrise_rad);

/// How she runs on even water at one speed, straight ahead.
struct RunningAttitude {
    double down_m = 0.0;     ///< of Bo, negative: risen
    double pitch_rad = 0.0;  ///< bow up
    double planing = 0.0;    ///< share of the lift that is of the flow: 0 afloat
};

/// A craft that planes, at work: attitude by speed, with all forces through the centre of gravity (the short
/// form of Savitsky 1964), worked out once. From C_V 0.6, where the formulas begin, to 1.6, the hump, she
/// goes over from floating to the running attitude.
class Planing {
public:
    Planing(const PlaningHull& bottom, const Hull& hull);

    RunningAttitude at(double surge_mps) const;
    /// Where the side force on the bottom acts, below the waterline at rest; negative above it. The pressure
    /// on each side of a wedge goes inward and up: in a slip the side that meets the water has more of it,
    /// and both lines meet b / (2 sin 2 beta) above the keel. Above the centre of gravity it heels her into
    /// the turn. Afloat it is `floating_m`.
    double sideForceDepth_m(double surge_mps, double floating_m) const;

private:
    RunningAttitude running(double surge_mps) const;

    PlaningHull m_bottom;
    double m_weight_N, m_density_kgpm3, m_length_m, m_draught_m;
    std::vector<RunningAttitude> m_attitudes;  ///< every kStep_mps
};

}  // namespace sagara::core
