#pragma once

/// Linear waves on water of constant depth: omega^2 = g k tanh(k h). Deep water: depth = kDeep_m.
namespace sagara::core {

inline constexpr double kDeep_m = 1e9;

double angularFrequency_radps(double waveNumber_radpm, double depth_m, double gravity_mps2);
/// Inverse of angularFrequency by Newton's method from the formula of Guo (2002); relative error below 1e-12.
double waveNumber_radpm(double omega_radps, double depth_m, double gravity_mps2);
/// The same in deep water.
inline double deepWaveNumber_radpm(double omega_radps, double gravity_mps2) {
    return omega_radps * omega_radps / gravity_mps2;
}
/// omega - k U cos mu, mu the heading less the direction of travel (180 deg head sea); negative when the ship
/// overtakes the waves.
double encounterFrequency_radps(double omega_radps, double waveNumber_radpm, double speed_mps,
                                double relativeHeading_rad);
/// d omega / d k.
double groupSpeed_mps(double waveNumber_radpm, double depth_m, double gravity_mps2);

}  // namespace sagara::core
