#include "app/tools/WaveTrial.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <vector>

#include "core/base/Units.h"
#include "core/motion/RungeKutta.h"
#include "core/sea/Dispersion.h"

namespace sagara::tools {
namespace {

constexpr double kSettlePeriods = 6.0;
constexpr double kSettle = 60.0;  ///< times sqrt(L/g): roll of a ship of usual damping has died out

/// Size of the first harmonic of one period of even samples, the straight line from end to end taken off.
double firstHarmonic(const std::vector<double>& period) {
    const auto steps = static_cast<double>(period.size() - 1);
    const double rise = period.back() - period.front();
    std::complex<double> sum;
    for (std::size_t i = 0; i + 1 < period.size(); ++i) {
        const double share = static_cast<double>(i) / steps;
        sum += (period[i] - rise * share) * std::polar(1.0, -core::kTwoPi * share);
    }
    return 2.0 * std::abs(sum) / steps;
}

}  // namespace

WaveAnswer answerToWave(const core::ShipDynamics& ship, double omega_radps, double relativeHeading_rad,
                        double amplitude_m) {
    const auto table = core::WaveTable::regular(omega_radps, 0.0, core::kDeep_m);
    const core::SeaState sea{{}, {0}, {amplitude_m}};
    const double period_s = core::kTwoPi / omega_radps;
    const int perPeriod = std::max(100, static_cast<int>(std::ceil(period_s / 0.05)));
    const double step_s = period_s / perPeriod;
    const double settle_s =
        std::max(kSettlePeriods * period_s, kSettle * std::sqrt(ship.length_m() / core::kGravity_mps2));
    const int settle = static_cast<int>(std::ceil(settle_s / period_s)) * perPeriod;
    auto waves = std::make_unique<core::ActiveWaves>();
    core::MovingShip moving;
    core::ShipMotion& m = moving.motion;
    m.heading_rad = relativeHeading_rad;
    std::vector<double> heave, roll, pitch;
    for (int i = 0; i <= settle + perPeriod; ++i) {
        if (i >= settle) heave.push_back(m.down_m), roll.push_back(m.roll_rad), pitch.push_back(m.pitch_rad);
        const auto middle_us = static_cast<std::int64_t>(1e6 * (i + 0.5) * step_s);
        core::activeWaves(table, sea, core::SimTime{middle_us}, *waves);
        core::ShipMotion there = m;  // in the waves of one place
        there.north_m = there.east_m = 0.0;
        const core::WaveEffect effect = ship.wavesAt(*waves, there, 1.0);
        moving = core::rk4Step(moving, step_s, [&](const core::MovingShip& x) {
            return ship.derivative(x, {}, {}, effect, {});
        });
        m.yawRate_radps = 0.0;
        m.heading_rad = relativeHeading_rad;
    }
    const double slope = amplitude_m * omega_radps * omega_radps / core::kGravity_mps2;
    return {firstHarmonic(heave) / amplitude_m, firstHarmonic(roll) / slope, firstHarmonic(pitch) / slope,
            std::abs(heave.back() - heave.front()) / amplitude_m};
}

}  // namespace sagara::tools
