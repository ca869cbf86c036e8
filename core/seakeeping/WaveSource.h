#pragma once

#include <complex>

namespace sagara::core {

/// F(u) = -exp(u) (E1(u) + i pi sign(Im u)) for Re u <= 0, u not 0: the principal value of the integral of
/// exp(u t) / (1 - t) over t > 0, which makes a source pulsating under a free surface (Frank 1967, NSRDC
/// 2375; Wehausen and Laitone 1960, eq. 13.31). E1 is the exponential integral. To 1e-5 of |1/u|.
std::complex<double> waveIntegral(std::complex<double> u);

}  // namespace sagara::core
