#pragma once

#include "core/base/Trig.h"
#include "core/vessel/Hull.h"

namespace sagara::core {

/// Rectangle with the area and the longitudinal second moment of the ship's waterplane. The outline is taken
/// as a rectangle with parabolic ends, b(x) = B (a + (1 - a)(1 - (2x/L)^2)) with a = 3 Cwp - 2 from the
/// coefficient, so the second moment is (1/30 + a/20) B L^3; for Cwp = 1 the rectangle is L x B itself.
struct Waterplane {
    double length_m = 0.0;
    double breadth_m = 0.0;
};
Waterplane waterplaneOf(const Hull& hull);

/// Integrals of one unit wave sin(phase + kx a + ky b) over a rectangle, a forward and b to starboard of its
/// centre: the sum the founding paper made over a grid, in closed form (Sandaruwan et al. 2010, eq 10 to 19,
/// corrected).
struct WaveIntegrals {
    double integral_m2;
    double firstMomentX_m3;
    double firstMomentY_m3;
};
WaveIntegrals waveIntegrals(const Waterplane& waterplane, double kx_radpm, double ky_radpm, double phase_rad);

/// How a wave of X = k l / 2 averages out over a length l; both 1 for long waves.
struct ShapeFactors {
    double mean;   ///< of cos over [-X, X]: sin X / X
    double slope;  ///< first moment of sin over that of its slope at the middle: 3 (sin X - X cos X) / X^3
};
inline ShapeFactors shapeFactors(double X) {
    // Both branches are computed and one chosen, so that a loop over components is vectorised. The series
    // serves where the closed forms cancel; at the change, X = 0.2, both agree to 1e-12.
    const double X2 = X * X;
    const bool small = X2 < 0.04;
    const double inverse = 1.0 / (small ? 1.0 : X);
    const SinCos sc = sinCos(X);
    const double mean = sc.sin * inverse;
    const double slope = 3.0 * (mean - sc.cos) * inverse * inverse;
    const double meanSeries = 1.0 - X2 / 6.0 * (1.0 - X2 / 20.0 * (1.0 - X2 / 42.0 * (1.0 - X2 / 72.0)));
    const double slopeSeries = 1.0 - X2 / 10.0 * (1.0 - X2 / 28.0 * (1.0 - X2 / 54.0 * (1.0 - X2 / 88.0)));
    return {small ? meanSeries : mean, small ? slopeSeries : slope};
}

}  // namespace sagara::core
