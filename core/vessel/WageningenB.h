#pragma once

#include <array>

namespace sagara::core {

/// A propeller of the Wageningen B-series in open water at Re 2e6: Oosterveld and van Oossanen (1975), Int.
/// Shipbuilding Progress 22(251), 251-262; table as transcribed by Bernitsas et al. (1981). Holds for 2 to 7
/// blades, AE/A0 0.30 to 1.05, P/D 0.5 to 1.4.
struct BScrew {
    int blades = 4;
    double areaRatio = 0.55;
    double pitchRatio = 0.8;

    double thrustCoefficient(double J) const;  ///< T / (rho n^2 D^4)
    double torqueCoefficient(double J) const;  ///< Q / (rho n^2 D^5)
    /// Their coefficients of 1, J, J^2, J^3.
    std::array<double, 4> thrustPolynomial() const;
    std::array<double, 4> torquePolynomial() const;
};

}  // namespace sagara::core
