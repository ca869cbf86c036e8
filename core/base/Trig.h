#pragma once

#include <bit>
#include <cstdint>

namespace sagara::core {

struct SinCos {
    double sin;
    double cos;
};

/// Sine and cosine together, without branches or library calls, so that a loop over it is vectorised and
/// gives the same bits on every x86-64 machine. For the wave sums only; elsewhere use <cmath>. Range: |angle|
/// < 1e6 rad. Error below 3e-14 + 3e-17 |angle|: three-part reduction by pi/2 (Cody and Waite 1980), Taylor
/// polynomials of degree 13 and 14 on [-pi/4, pi/4].
inline SinCos sinCos(double angle_rad) {
    constexpr double kRound = 0x1.8p52;  // adding it leaves the nearest integer in the low bits
    constexpr double kTwoOverPi = 0.63661977236758134308;
    constexpr double kHigh = 1.57079632673412561417e+00;  // pi/2, first 33 bits
    constexpr double kMiddle = 6.07710050630396597660e-11;
    constexpr double kLow = 2.02226624879595063154e-21;
    const double shifted = angle_rad * kTwoOverPi + kRound;
    const double quarter = shifted - kRound;
    const auto bits = std::bit_cast<std::uint64_t>(shifted);
    const double r = ((angle_rad - quarter * kHigh) - quarter * kMiddle) - quarter * kLow;
    const double r2 = r * r;
    const double s =
        r + r * r2 *
                (-1.0 / 6 + r2 * (1.0 / 120 +
                                  r2 * (-1.0 / 5040 + r2 * (1.0 / 362880 + r2 * (-1.0 / 39916800 +
                                                                                 r2 * (1.0 / 6227020800))))));
    const double c =
        1.0 +
        r2 * (-0.5 +
              r2 * (1.0 / 24 +
                    r2 * (-1.0 / 720 +
                          r2 * (1.0 / 40320 +
                                r2 * (-1.0 / 3628800 + r2 * (1.0 / 479001600 - r2 * (1.0 / 87178291200)))))));
    const std::uint64_t odd =
        0 - (bits & 1);  // all ones in the odd quarters, where sine and cosine change places
    const auto sBits = std::bit_cast<std::uint64_t>(s);
    const auto cBits = std::bit_cast<std::uint64_t>(c);
    const std::uint64_t sinBits = ((sBits & ~odd) | (cBits & odd)) ^ ((bits & 2) << 62);
    const std::uint64_t cosBits = ((cBits & ~odd) | (sBits & odd)) ^ (((bits + 1) & 2) << 62);
    return {std::bit_cast<double>(sinBits), std::bit_cast<double>(cosBits)};
}

}  // namespace sagara::core
