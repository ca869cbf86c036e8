#include "core/motion/HeightMotion.h"

#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

/// (1 - cos X) / X, by its series where that cancels.
double halfFactor(double X) {
    return std::abs(X) < 1e-4 ? 0.5 * X * (1.0 - X * X / 12.0) : (1.0 - std::cos(X)) / X;
}

/// Volume between the halves of a rectangle that is tilted by one radian about its middle.
double halvesPerTilt_m3(double length_m, double breadth_m) { return 0.25 * length_m * length_m * breadth_m; }

}  // namespace

WaveHeights waveHeights(const Waterplane& plane, double kx_radpm, double ky_radpm, double phase_rad) {
    const double X = 0.5 * kx_radpm * plane.length_m, Y = 0.5 * ky_radpm * plane.breadth_m;
    const double area_m2 = plane.length_m * plane.breadth_m;
    const double meanX = shapeFactors(X).mean, meanY = shapeFactors(Y).mean;
    const double c = std::cos(phase_rad);
    return {area_m2 * std::sin(phase_rad) * meanX * meanY, area_m2 * c * halfFactor(X) * meanY,
            area_m2 * c * halfFactor(Y) * meanX};
}

WaveHeights waveHeights(const Waterplane& plane, const ActiveWaves& waves, NorthEast position,
                        double heading_rad) {
    const double c = std::cos(heading_rad), s = std::sin(heading_rad);
    WaveHeights sum;
    for (std::size_t i = 0; i < waves.count; ++i) {
        const double kN = waves.kNorth_radpm[i], kE = waves.kEast_radpm[i];
        const double phase_rad = kN * position.north_m + kE * position.east_m + waves.phase_rad[i];
        const WaveHeights one = waveHeights(plane, kN * c + kE * s, kE * c - kN * s,
                                            phase_rad + 0.5 * kPi);  // height is a cosine
        sum.sum_m3 += waves.amplitude_m[i] * one.sum_m3;
        sum.along_m3 += waves.amplitude_m[i] * one.along_m3;
        sum.across_m3 += waves.amplitude_m[i] * one.across_m3;
    }
    return sum;
}

HeightMotion::HeightMotion(const TransferModel& model, const Vessel& vessel)
    : m_model(model),
      m_plane(waterplaneOf(vessel.hull)),
      m_density_kgpm3(vessel.hull.waterDensity_kgpm3),
      m_mass_kg(vessel.hull.mass_kg()) {
    const Hull& hull = vessel.hull;
    const double l = m_plane.length_m, w = m_plane.breadth_m, weight = m_density_kgpm3 * kGravity_mps2;
    if (m_model.waves == WaveFeeling::HeightsPrinted) {  // a cuboid, eq 18
        m_pitchInertia_kgm2 = m_mass_kg * (l * l + hull.draught_m * hull.draught_m) / 12.0;
        m_rollInertia_kgm2 = m_mass_kg * (w * w + hull.draught_m * hull.draught_m) / 12.0;
    } else {
        m_pitchInertia_kgm2 = m_mass_kg * hull.pitchGyradius_m * hull.pitchGyradius_m;
        m_rollInertia_kgm2 = m_mass_kg * hull.rollGyradius_m * hull.rollGyradius_m;
    }
    const auto damping = [](double ratio, double stiffness, double inertia) {
        return 2.0 * ratio * std::sqrt(stiffness * inertia);
    };
    const Seakeeping& s = vessel.seakeeping;
    m_heaveDamping = damping(s.heaveDampingRatio, weight * l * w, m_mass_kg);
    m_pitchDamping =
        damping(s.pitchDampingRatio, weight * 0.25 * l * halvesPerTilt_m3(l, w), m_pitchInertia_kgm2);
    m_rollDamping =
        damping(s.rollDampingRatio, weight * 0.25 * w * halvesPerTilt_m3(w, l), m_rollInertia_kgm2);
}

void HeightMotion::apply(const ShipMotion& m, const Load& external, const WaveHeights& heights,
                         ShipMotion& rate) const {
    if (m_model.waves == WaveFeeling::HeightsPrinted) return applyPrinted(m, heights, rate);
    const double l = m_plane.length_m, w = m_plane.breadth_m, weight = m_density_kgpm3 * kGravity_mps2;
    // Each half is pushed up at a quarter of the length, or of the breadth, from the middle.
    const double up_m3 = heights.sum_m3 + l * w * m.down_m;
    const double bowUp_m3 = heights.along_m3 - halvesPerTilt_m3(l, w) * m.pitch_rad;
    const double starboardUp_m3 = heights.across_m3 + halvesPerTilt_m3(w, l) * m.roll_rad;
    rate.heaveRate_mps = (external.heave_N - weight * up_m3 - m_heaveDamping * m.heaveRate_mps) / m_mass_kg;
    rate.pitchRate_radps =
        (external.pitch_Nm + weight * 0.25 * l * bowUp_m3 - m_pitchDamping * m.pitchRate_radps) /
        m_pitchInertia_kgm2;
    rate.rollRate_radps =
        (external.roll_Nm - weight * 0.25 * w * starboardUp_m3 - m_rollDamping * m.rollRate_radps) /
        m_rollInertia_kgm2;
}

void HeightMotion::applyPrinted(const ShipMotion& m, const WaveHeights& heights, ShipMotion& rate) const {
    // Heights times the specific weight in kg/m3; w^2 does not change sign with w (eq 11), and so drives her.
    const double up_mps = -m.heaveRate_mps;
    const double heave_mps2 =
        heights.sum_m3 * m_density_kgpm3 / m_mass_kg - m_model.heaveDamping_perm * up_mps * up_mps;
    rate.heaveRate_mps = -heave_mps2;
    rate.pitchRate_radps = heights.along_m3 * m_density_kgpm3 / m_pitchInertia_kgm2 -
                           m_model.pitchDamping_perS * m.pitchRate_radps;
    rate.rollRate_radps = -heights.across_m3 * m_density_kgpm3 / m_rollInertia_kgm2 -
                          m_model.rollDamping_perS * m.rollRate_radps;
}

}  // namespace sagara::core
