#include "core/seakeeping/WaveSource.h"

#include <cmath>
#include <numbers>

namespace sagara::core {
namespace {

using Complex = std::complex<double>;

/// Products written out: std::complex's own checks every one for infinities.
Complex times(Complex a, Complex b) {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

/// Abramowitz and Stegun 5.1.11, with the cut moved to where Re u > 0.
Complex bySeries(Complex u) {
    Complex term(1.0, 0.0), sum = std::numbers::egamma + std::log(-u);
    const double size = std::norm(u);
    for (int k = 1; k < 80; ++k) {
        term = times(term, -u) / static_cast<double>(k);
        sum += term / static_cast<double>(k);
        if (k * k > size && std::norm(term) < 1e-26 * std::norm(sum)) break;
    }
    return times(std::exp(u), sum);
}

/// Abramowitz and Stegun 5.1.51, up to its least term.
Complex byAsymptote(Complex u) {
    const Complex inverse = 1.0 / u;
    Complex term = -inverse, sum = term;
    for (int k = 1; k < 12; ++k) {
        term = -static_cast<double>(k) * times(term, inverse);
        sum += term;
    }
    return sum - Complex(0.0, std::copysign(std::numbers::pi, u.imag())) * std::exp(u);
}

}  // namespace

Complex waveIntegral(Complex u) { return std::norm(u) < 144.0 ? bySeries(u) : byAsymptote(u); }

}  // namespace sagara::core
