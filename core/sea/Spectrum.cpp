#include "core/sea/Spectrum.h"

#include <cmath>

#include "core/base/Angle.h"

namespace sagara::core {

double bretschneider_m2s(double omega_radps, double significantHeight_m, double peakPeriod_s) {
    if (omega_radps <= 0.0) return 0.0;
    const double ratio = kTwoPi / peakPeriod_s / omega_radps;
    const double ratio4 = ratio * ratio * ratio * ratio;
    return 5.0 / 16.0 * significantHeight_m * significantHeight_m * ratio4 / omega_radps *
           std::exp(-1.25 * ratio4);
}

double jonswap_m2s(double omega_radps, double significantHeight_m, double peakPeriod_s, double gamma) {
    const double peak_radps = kTwoPi / peakPeriod_s;
    const double width = omega_radps <= peak_radps ? 0.07 : 0.09;
    const double x = (omega_radps - peak_radps) / (width * peak_radps);
    return (1.0 - 0.287 * std::log(gamma)) * std::pow(gamma, std::exp(-0.5 * x * x)) *
           bretschneider_m2s(omega_radps, significantHeight_m, peakPeriod_s);
}

double spreading_perRad(double theta_rad, double s) {
    const double norm = std::tgamma(s + 1.0) / (2.0 * std::sqrt(kPi) * std::tgamma(s + 0.5));
    return norm * std::pow(std::cos(0.5 * wrapPi(theta_rad)), 2.0 * s);
}

double peakOverMeanPeriod(double gamma) {
    constexpr double kGamma[] = {1.0, 2.0, 3.3, 5.0}, kMeanOverPeak[] = {0.7718, 0.8063, 0.8344, 0.8584};
    int i = 0;
    while (i < 2 && gamma > kGamma[i + 1]) ++i;
    const double fraction = (gamma - kGamma[i]) / (kGamma[i + 1] - kGamma[i]);
    return 1.0 / (kMeanOverPeak[i] + (kMeanOverPeak[i + 1] - kMeanOverPeak[i]) * fraction);
}

}  // namespace sagara::core
