#pragma once

namespace sagara::core {

/// A hull as the regression of Holtrop and Mennen asks for it.
struct HoltropHull {
    double length_m;  ///< on the waterline
    double beam_m;
    double draught_m;  ///< mean
    double volume_m3;
    double waterplane;          ///< C_WP
    double midship;             ///< C_M
    double buoyancy_pct = 0.0;  ///< centre of buoyancy forward of half the length, % of it
    double bulb_m2 = 0.0;       ///< its section at the forward perpendicular
    double bulbHeight_m = 0.0;  ///< of that section's centre above the keel
    double transom_m2 = 0.0;    ///< immersed at rest
    double sternForm = 0.0;     ///< C_stern: -10 V-shaped, 0 normal, 10 U-shaped sections
    double appendages_m2 = 0.0;
    double appendageForm = 1.5;  ///< 1 + k2

    double prismatic() const { return volume_m3 / (length_m * beam_m * draught_m * midship); }
};

/// Parts of the resistance in still, deep water, N.
struct HoltropResistance {
    double wetted_m2 = 0.0;
    double formFactor = 1.0;  ///< 1 + k1
    double friction_N = 0.0;  ///< ITTC 1957, of the hull alone, without the form factor
    double appendages_N = 0.0;
    double waves_N = 0.0;
    double bulb_N = 0.0;
    double transom_N = 0.0;
    double allowance_N = 0.0;  ///< model to ship, C_A

    double total_N() const {
        return formFactor * friction_N + appendages_N + waves_N + bulb_N + transom_N + allowance_N;
    }
};

/// Holtrop and Mennen (1982), Int. Shipbuilding Progress 29, 166-170, with the wave resistance and form
/// factor of Holtrop (1984), ISP 31, 272-276. For hulls `holtropHolds` of. Speeds over 0 m/s.
HoltropResistance holtropResistance(const HoltropHull& hull, double speed_mps, double density_kgpm3,
                                    double viscosity_m2ps);

/// Whether she is of the ships the regression was made of: L/B 3.9 to 15, B/T 2.1 to 4, C_P 0.55 to 0.85,
/// Froude number up to 0.45.
bool holtropHolds(const HoltropHull& hull, double speed_mps);

}  // namespace sagara::core
