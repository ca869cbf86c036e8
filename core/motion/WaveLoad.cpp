#include "core/motion/WaveLoad.h"

#include <algorithm>
#include <cmath>

#include "core/base/Trig.h"
#include "core/base/Units.h"

namespace sagara::core {

double smithFactor(double waveNumber_radpm, double z_m, double depth_m) {
    const double kh = waveNumber_radpm * depth_m, kz = waveNumber_radpm * std::min(z_m, depth_m);
    return std::exp(-kz) * (1.0 + std::exp(-2.0 * (kh - kz))) / (1.0 + std::exp(-2.0 * kh));
}

WaveLoad::WaveLoad(const Vessel& vessel, const Coefficients& coefficients, const WaveTable& table,
                   WaveFeeling feeling)
    : m_waterplane(waterplaneOf(vessel.hull)), m_c(coefficients), m_feeling(feeling) {
    const double meanDraught_m = vessel.hull.displacement_m3 / vessel.hull.waterplaneArea_m2();
    for (const WaveComponent& c : table.components()) {
        m_smith.push_back(
            smithFactor(std::hypot(c.kNorth_radpm, c.kEast_radpm), meanDraught_m, table.depth_m()));
    }
}

WaveEffect WaveLoad::at(const SeaState& sea, const ActiveWaves& waves, NorthEast position, double heading_rad,
                        double shelter) const {
    if (m_feeling == WaveFeeling::Blind) return {};
    if (m_feeling != WaveFeeling::Pressure) {
        const WaveHeights h = waveHeights(m_waterplane, waves, position, heading_rad);
        WaveEffect effect;
        effect.heights = {shelter * h.sum_m3, shelter * h.along_m3, shelter * h.across_m3};
        return effect;
    }
    const double c = std::cos(heading_rad), s = std::sin(heading_rad), g = kGravity_mps2;
    const double halfLength_m = 0.5 * m_waterplane.length_m, halfBreadth_m = 0.5 * m_waterplane.breadth_m;
    alignas(16) double amplitude_m[kMostActiveComponents];
    for (std::size_t i = 0; i < waves.count; ++i)
        amplitude_m[i] = waves.amplitude_m[i] * m_smith[sea.active[i]];

    // Blocks of components: the first loop has neither branches nor sums, so the compiler vectorises it; the
    // second adds in the order of the components, so the result is the same bits everywhere.
    constexpr std::size_t kBlock = 64;
    alignas(16) double surge[kBlock], sway[kBlock], heave[kBlock], roll[kBlock], pitch[kBlock], yaw[kBlock];
    Load sum;
    for (std::size_t begin = 0; begin < waves.count; begin += kBlock) {
        const std::size_t size = std::min(kBlock, waves.count - begin);
        const double* const kNorth = waves.kNorth_radpm + begin;
        const double* const kEast = waves.kEast_radpm + begin;
        const double* const start = waves.phase_rad + begin;
        const double* const frequency = waves.omega_radps + begin;
        const double* const height = amplitude_m + begin;
        for (std::size_t i = 0; i < size; ++i) {
            const double kx = kNorth[i] * c + kEast[i] * s, ky = kEast[i] * c - kNorth[i] * s;
            const double omega = frequency[i];
            const SinCos wave = sinCos(kNorth[i] * position.north_m + kEast[i] * position.east_m + start[i]);
            const ShapeFactors x = shapeFactors(kx * halfLength_m), y = shapeFactors(ky * halfBreadth_m);
            const double mean = height[i] * x.mean * y.mean, slope = height[i] * kx * x.slope * y.mean;
            surge[i] = mean * kx * wave.sin;
            sway[i] = mean * ky * wave.sin;
            // The water's height is cos, its velocity omega sin, its acceleration -omega^2 cos; slopes
            // likewise.
            heave[i] = mean * ((m_c.heaveStiffness - omega * omega * m_c.heaveAddedMass) * wave.cos +
                               omega * m_c.heaveDamping * wave.sin);
            roll[i] = height[i] * ky * x.mean * y.slope * wave.sin;
            pitch[i] = slope * ((omega * omega * m_c.pitchAddedInertia - m_c.pitchStiffness) * wave.sin +
                                omega * m_c.pitchDamping * wave.cos);
            yaw[i] = slope * ky * wave.cos;
        }
        for (std::size_t i = 0; i < size; ++i) {
            sum = sum + Load{surge[i], sway[i], -heave[i], roll[i], pitch[i], yaw[i]};
        }
    }
    // Slope of the surface times g is the acceleration of the water.
    return {.load = shelter * Load{.heave_N = sum.heave_N,
                                   .roll_Nm = m_c.rollStiffness * sum.roll_Nm,
                                   .pitch_Nm = sum.pitch_Nm},
            .surge_mps2 = shelter * g * sum.surge_N,
            .sway_mps2 = shelter * g * sum.sway_N,
            .yaw_radps2 = shelter * g * sum.yaw_Nm,
            .heights = {}};
}

}  // namespace sagara::core
