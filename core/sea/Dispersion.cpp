#include "core/sea/Dispersion.h"

#include <cmath>

namespace sagara::core {

double angularFrequency_radps(double waveNumber_radpm, double depth_m, double gravity_mps2) {
    return std::sqrt(gravity_mps2 * waveNumber_radpm * std::tanh(waveNumber_radpm * depth_m));
}

double encounterFrequency_radps(double omega_radps, double waveNumber_radpm, double speed_mps,
                                double relativeHeading_rad) {
    return omega_radps - waveNumber_radpm * speed_mps * std::cos(relativeHeading_rad);
}

double groupSpeed_mps(double waveNumber_radpm, double depth_m, double gravity_mps2) {
    const double kh = waveNumber_radpm * depth_m;
    const double phaseSpeed_mps =
        angularFrequency_radps(waveNumber_radpm, depth_m, gravity_mps2) / waveNumber_radpm;
    const double n = kh > 20.0 ? 0.5 : 0.5 + kh / std::sinh(2.0 * kh);
    return n * phaseSpeed_mps;
}

double waveNumber_radpm(double omega_radps, double depth_m, double gravity_mps2) {
    const double deep_radpm = omega_radps * omega_radps / gravity_mps2;
    const double x = omega_radps * std::sqrt(depth_m / gravity_mps2);
    double k = deep_radpm / std::pow(1.0 - std::exp(-std::pow(x, 2.4908)), 1.0 / 2.4908);
    for (int i = 0; i < 4; ++i) {
        const double tanhKh = std::tanh(k * depth_m);
        const double slope = tanhKh + k * depth_m * (1.0 - tanhKh * tanhKh);
        k -= (k * tanhKh - deep_radpm) / slope;
    }
    return k;
}

}  // namespace sagara::core
