#include "core/sea/WindSpectrum.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {

std::string_view gustSpectrumName(GustSpectrum spectrum) {
    constexpr std::string_view kNames[] = {"davenport", "harris", "kaimal", "froya"};
    return kNames[static_cast<std::size_t>(spectrum)];
}

double seaDragCoefficient(double wind10_mps) {
    const double u = std::min(wind10_mps, 25.0);
    return u < 11.0 ? 1.2e-3 : (0.49 + 0.065 * u) * 1e-3;
}

double gustDensity(GustSpectrum spectrum, double frequency_Hz, double wind10_mps) {
    if (frequency_Hz <= 0.0 || wind10_mps <= 0.0) return 0.0;
    const double u = wind10_mps, f = frequency_Hz, friction2 = seaDragCoefficient(u) * u * u;
    switch (spectrum) {
        case GustSpectrum::Davenport: {
            const double x = 1200.0 * f / u;
            return 4.0 * friction2 * x * x / (f * std::pow(1.0 + x * x, 4.0 / 3.0));
        }
        case GustSpectrum::Harris: {
            const double x = 1800.0 * f / u;
            return 4.0 * friction2 * x / (f * std::pow(2.0 + x * x, 5.0 / 6.0));
        }
        case GustSpectrum::Kaimal: {
            const double n = 10.0 * f / u;
            return 105.0 * friction2 * n / (f * std::pow(1.0 + 33.0 * n, 5.0 / 3.0));
        }
        case GustSpectrum::Froya: {
            const double x = 172.0 * f * std::pow(u / 10.0, -0.75);
            return 320.0 * std::pow(u / 10.0, 2) / std::pow(1.0 + std::pow(x, 0.468), 5.0 / (3.0 * 0.468));
        }
    }
    return 0.0;
}

double windFactorAt(double height_m, WindProfile profile, double wind10_mps) {
    const double ratio = std::max(height_m, 1.0) / 10.0;
    switch (profile) {
        case WindProfile::Uniform:
            return 1.0;
        case WindProfile::Power:
            return std::pow(ratio, 0.12);
        case WindProfile::Logarithmic:  // Karman's 0.4 over the root of the drag coefficient is ln(10/z0)
            return 1.0 + std::log(ratio) * std::sqrt(seaDragCoefficient(wind10_mps)) / 0.4;
        case WindProfile::Froya:
            return 1.0 + 0.0573 * std::sqrt(1.0 + 0.15 * wind10_mps) * std::log(ratio);
    }
    return 1.0;
}

}  // namespace sagara::core
