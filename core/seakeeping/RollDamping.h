#pragma once

namespace sagara::core {

/// Simple prediction of Ikeda's roll damping: Kawahara, Maekawa and Ikeda (2009), STAB, zero speed. The
/// regression holds for CB 0.5 to 0.85, B/d 2.5 to 4.5, OG/d -1.5 to 0.2, CM 0.9 to 0.99, bilge keels of 0.01
/// to 0.06 B by 0.05 to 0.4 Lpp, w sqrt(B/2g) up to 1.
struct IkedaShip {
    double lengthBp_m = 0.0;
    double breadth_m = 0.0;
    double draught_m = 0.0;
    double blockCoefficient = 0.0;
    double midshipCoefficient = 0.0;
    double gravityBelowWater_m = 0.0;  ///< OG: below nothing where G is above the waterline
    double bilgeKeelLength_m = 0.0;
    double bilgeKeelBreadth_m = 0.0;
};

/// B44 / (rho volume B^2) sqrt(B / 2g), equivalent linear at the amplitude.
struct IkedaDamping {
    double friction = 0.0;
    double wave = 0.0;
    double eddy = 0.0;
    double bilgeKeel = 0.0;

    double total() const { return friction + wave + eddy + bilgeKeel; }
};

/// The formulas as printed, wherever they are asked. `viscosity_m2ps` of the water.
IkedaDamping ikedaDamping(const IkedaShip& ship, double amplitude_rad, double omega_radps,
                          double viscosity_m2ps = 1.14e-6);

/// The nearest ship inside the range of the regression: coefficients clamped, and the draught's ratios.
IkedaShip inRange(IkedaShip ship);

/// Everything but the wave part, N m s, with forward speed: friction grows, eddies are washed away and the
/// hull lifts (Himeno 1981, Univ. of Michigan 239; ITTC 7.5-02-07-04.5). The regression is asked `inRange`.
double viscousRollDamping_Nms(const IkedaShip& ship, double waterDensity_kgpm3, double volume_m3,
                              double amplitude_rad, double omega_radps, double speed_mps);

}  // namespace sagara::core
