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

double ittc_m2s(double omega_radps, double significantHeight_m, double meanPeriod_s) {
    if (omega_radps <= 0.0) return 0.0;
    const double t4 = std::pow(meanPeriod_s, 4), w4 = std::pow(omega_radps, 4);
    return 173.0 * significantHeight_m * significantHeight_m / (t4 * w4 * omega_radps) *
           std::exp(-691.0 / (t4 * w4));
}

double ittcJonswap_m2s(double omega_radps, double significantHeight_m, double meanPeriod_s) {
    if (omega_radps <= 0.0) return 0.0;
    const double t4 = std::pow(meanPeriod_s, 4), w4 = std::pow(omega_radps, 4);
    const double width = omega_radps <= 5.24 / meanPeriod_s ? 0.07 : 0.09;
    const double x = (0.191 * omega_radps * meanPeriod_s - 1.0) / (std::sqrt(2.0) * width);
    return 155.0 * significantHeight_m * significantHeight_m / (t4 * w4 * omega_radps) *
           std::exp(-944.0 / (t4 * w4)) * std::pow(3.3, std::exp(-x * x));
}

double ochiHubble_m2s(double omega_radps, double significantHeight_m, double peakPeriod_s, double lambda) {
    if (omega_radps <= 0.0 || significantHeight_m <= 0.0) return 0.0;
    const double ratio4 = std::pow(kTwoPi / peakPeriod_s / omega_radps, 4), q = lambda + 0.25;
    // By logarithms: the power of the frequency alone would leave the range of double for steep forms.
    return 0.25 * significantHeight_m * significantHeight_m / omega_radps *
           std::exp(lambda * std::log(q * ratio4) - std::lgamma(lambda) - q * ratio4);
}

double spectrum_m2s(const SeaSystem& system, double omega_radps) {
    const double height_m = system.significantHeight_m;
    switch (system.family) {
        case SpectrumFamily::Jonswap:
            return jonswap_m2s(omega_radps, height_m, system.peakPeriod_s, system.gamma);
        case SpectrumFamily::OchiHubble:
            return ochiHubble_m2s(omega_radps, height_m, system.peakPeriod_s, system.form);
        case SpectrumFamily::Band: {
            const double middle_radps = kTwoPi / system.peakPeriod_s,
                         width_radps = system.form * middle_radps;
            const bool inside = std::abs(omega_radps - middle_radps) <= 0.5 * width_radps;
            return inside ? height_m * height_m / 16.0 / width_radps : 0.0;
        }
    }
    return 0.0;
}

double spreading_perRad(const SeaSystem& system, double theta_rad) {
    return system.law == SpreadingLaw::Cos2s ? spreading_perRad(theta_rad, system.spreading)
                                             : halfPlaneSpreading_perRad(theta_rad, system.spreading);
}

double halfPlaneSpreading_perRad(double theta_rad, double n) {
    const double c = std::cos(theta_rad);
    if (c <= 0.0) return 0.0;
    return std::tgamma(0.5 * n + 1.0) / (std::sqrt(kPi) * std::tgamma(0.5 * n + 0.5)) * std::pow(c, n);
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
