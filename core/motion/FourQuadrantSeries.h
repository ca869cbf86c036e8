#pragma once

namespace sagara::core {

/// Thrust and torque over 1/2 rho V^2 (pi / 4) D^2 (torque: D^3), V^2 = va^2 + (0.7 pi n D)^2; torque is what
/// the shaft has to give, positive where the water holds back a shaft that turns ahead.
struct StarCoefficients {
    double thrust = 0.0;  ///< CT*
    double torque = 0.0;  ///< CQ*
};

/// Wageningen B4 propellers in all quadrants of the advance angle beta = atan2(va, 0.7 pi n D), from the
/// measured series of P/D 0.5, 0.8, 1.0, 1.4 (area ratio 0.70) and area ratio 0.40, 1.00 (P/D 1.0): first 21
/// Fourier terms as published by Roddy, Hess and Faller (2006), NSWCCD-50-TR-2006/004, of van Lammeren, van
/// Manen and Oosterveld (1969), Trans. SNAME 77. Read off a table of one degree; straight lines between
/// pitches and areas, which are held beyond the ends. A pitch below 0 is the same blade turning the other way
/// (beta -> pi - beta); between -0.5 and 0.5 the two are mixed, no pitch giving no thrust at rest: trend only
/// there.
StarCoefficients fourQuadrants(double beta_rad, double pitchRatio, double areaRatio);

}  // namespace sagara::core
