#include "core/sea/SeaOrder.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

SeaSystem train(const SeaOrder& order, double height_m, double peak_s, double gamma) {
    SeaSystem system(WaveSystem{height_m, peak_s, gamma, order.wavesTo_rad, order.spreading});
    system.law = order.law;
    return system;
}

/// The most probable member of the family of a significant height: Ochi and Hubble (1976), table 2b, first
/// row.
std::vector<SeaSystem> mostProbable(const SeaOrder& order) {
    const double h = order.significantHeight_m;
    SeaSystem swell = train(order, 0.84 * h, kTwoPi / (0.70 * std::exp(-0.046 * h)), 1.0);
    SeaSystem wind = train(order, 0.54 * h, kTwoPi / (1.15 * std::exp(-0.039 * h)), 1.0);
    swell.family = wind.family = SpectrumFamily::OchiHubble;
    swell.form = 3.0;
    wind.form = 1.54 * std::exp(-0.062 * h);
    return {swell, wind};
}

}  // namespace

std::string_view seaSpectrumName(SeaSpectrum spectrum) {
    constexpr std::string_view kNames[] = {"pierson-moskowitz", "bretschneider", "ittc", "jonswap",
                                           "ochi-hubble"};
    return kNames[static_cast<std::size_t>(spectrum)];
}

HeightAndPeak fullyDeveloped(double wind10_mps) {
    const double v = 1.026 * wind10_mps;
    return {0.21 * v * v / kGravity_mps2, kTwoPi * v / (0.877 * kGravity_mps2)};
}

std::vector<SeaSystem> systemsOf(const SeaOrder& order) {
    switch (order.spectrum) {
        case SeaSpectrum::PiersonMoskowitz: {
            const HeightAndPeak sea = fullyDeveloped(order.wind_mps);
            return {train(order, sea.significantHeight_m, sea.peakPeriod_s, 1.0)};
        }
        case SeaSpectrum::Bretschneider:
            return {train(order, order.significantHeight_m, order.peakPeriod_s, 1.0)};
        case SeaSpectrum::Ittc:  // the peak of A w^-5 exp(-B w^-4) is at w^4 = 4 B / 5
            return {train(order, order.significantHeight_m,
                          kTwoPi * order.meanPeriod_s / std::pow(0.8 * 691.0, 0.25), 1.0)};
        case SeaSpectrum::Jonswap:
            return {train(order, order.significantHeight_m, order.peakPeriod_s, order.gamma)};
        case SeaSpectrum::OchiHubble:
            return mostProbable(order);
    }
    return {};
}

double spectrum_m2s(const std::vector<SeaSystem>& systems, double omega_radps) {
    double sum = 0.0;
    for (const SeaSystem& system : systems) sum += spectrum_m2s(system, omega_radps);
    return sum;
}

SeaStatistics statisticsOf(const std::vector<SeaSystem>& systems) {
    constexpr double kLow_radps = 0.02, kHigh_radps = 30.0;
    constexpr int kSteps = 12'000;  // even in the logarithm: 0.06 % of the frequency each
    const double ratio = std::log(kHigh_radps / kLow_radps) / kSteps;
    SeaStatistics s;
    double highest = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double omega = kLow_radps * std::exp((i + 0.5) * ratio);
        const double density = spectrum_m2s(systems, omega), energy = density * omega * ratio;
        s.m0_m2 += energy;
        s.m1 += energy * omega;
        s.m2 += energy * omega * omega;
        if (density > highest) {
            highest = density;
            s.peakPeriod_s = kTwoPi / omega;
        }
    }
    for (int i = 0; i < kSteps; ++i) {
        const double omega = kLow_radps * std::exp((i + 0.5) * ratio);
        if (omega * s.peakPeriod_s > 4.0 * kTwoPi) break;
        s.m4 += spectrum_m2s(systems, omega) * std::pow(omega, 5) * ratio;
    }
    return s;
}

double SeaStatistics::significantHeight_m() const { return 4.0 * std::sqrt(m0_m2); }
double SeaStatistics::meanPeriod_s() const { return m1 > 0.0 ? kTwoPi * m0_m2 / m1 : 0.0; }
double SeaStatistics::zeroUpcrossing_s() const { return m2 > 0.0 ? kTwoPi * std::sqrt(m0_m2 / m2) : 0.0; }
double SeaStatistics::bandwidth() const {
    return m4 > 0.0 ? std::sqrt(std::max(0.0, 1.0 - m2 * m2 / (m0_m2 * m4))) : 0.0;
}
double SeaStatistics::highestOf_m(double waves) const {
    return waves > 1.0 ? significantHeight_m() * std::sqrt(0.5 * std::log(waves)) : 0.0;
}

int wmoSeaState(double significantHeight_m) {
    constexpr double kUpTo_m[] = {0.0, 0.1, 0.5, 1.25, 2.5, 4.0, 6.0, 9.0, 14.0};
    int code = 0;
    while (code < 9 && significantHeight_m > kUpTo_m[code]) ++code;
    return code;
}

}  // namespace sagara::core
