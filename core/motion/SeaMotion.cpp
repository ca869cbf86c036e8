#include "core/motion/SeaMotion.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace sagara::core {
namespace {

constexpr std::size_t kSurge = 0, kSway = 1, kHeave = 2, kRoll = 3, kPitch = 4, kYaw = 5;
constexpr std::array<std::size_t, 3> kLateral{kSway, kRoll, kYaw}, kVertical{kSurge, kHeave, kPitch};

Matrix6 sum(const Matrix6& a, const Matrix6& b) {
    Matrix6 s;
    for (std::size_t i = 0; i < s.value.size(); ++i) s.value[i] = a.value[i] + b.value[i];
    return s;
}

std::array<std::array<double, 3>, 3> inverse(const Matrix6& m, const std::array<std::size_t, 3>& of) {
    Eigen::Matrix3d part;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            part(i, j) = m(of[static_cast<std::size_t>(i)], of[static_cast<std::size_t>(j)]);
    const Eigen::Matrix3d inverted = part.inverse();
    std::array<std::array<double, 3>, 3> square{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            square[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = inverted(i, j);
    return square;
}

double row(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Speed up to which strip theory is asked: that of the tables, and where the moment of a hull that pitches
/// at speed, U^2 A33, takes no more than a quarter of what rights her. Beyond (short beamy hulls, planing
/// craft) it would turn her over on calm water; she keeps the terms of that speed.
double fastest_mps(const SeaHull& hull, const Matrix6& slow) {
    const double added_kg = slow(kHeave, kHeave) - hull.mass(kHeave, kHeave);
    return std::min(hull.speeds_mps.back(),
                    0.5 * std::sqrt(std::max(0.0, hull.restoring(kPitch, kPitch)) / added_kg));
}

}  // namespace

SeaMotion::SeaMotion(std::shared_ptr<const SeaHull> hull, bool ownsRoll,
                     const std::optional<ViscousRoll>& rollDamping)
    : m_hull(std::move(hull)),
      m_ownsRoll(ownsRoll),
      m_rollDamping(rollDamping),
      m_slow(sum(sum(m_hull->mass, m_hull->addedMass), m_hull->memory.slowAddedMass())),
      m_fastest_mps(fastest_mps(*m_hull, m_slow)) {
    Matrix6 atOnce = sum(m_hull->mass, m_hull->addedMass);
    if (m_ownsRoll) {
        const double determinant =
            m_slow(kSway, kSway) * m_slow(kYaw, kYaw) - m_slow(kSway, kYaw) * m_slow(kYaw, kSway);
        m_swayInRoll =
            (m_slow(kRoll, kSway) * m_slow(kYaw, kYaw) - m_slow(kRoll, kYaw) * m_slow(kYaw, kSway)) /
            determinant;
        m_yawInRoll =
            (m_slow(kRoll, kYaw) * m_slow(kSway, kSway) - m_slow(kRoll, kSway) * m_slow(kSway, kYaw)) /
            determinant;
        for (const std::size_t i : {kSway, kYaw}) atOnce(i, kRoll) = atOnce(kRoll, i) = 0.0;
        atOnce(kRoll, kRoll) = 1.0;
    }
    m_lateral = inverse(atOnce, kLateral);
    m_vertical = inverse(atOnce, kVertical);
}

double SeaMotion::effectiveHeel_rad(const WaveForces& waves) const {
    if (!m_ownsRoll) return 0.0;
    return (waves.first[kRoll] - m_swayInRoll * waves.first[kSway] - m_yawInRoll * waves.first[kYaw]) /
           m_hull->restoring(kRoll, kRoll);
}

double SeaMotion::ahead(double surge_mps) const { return std::clamp(surge_mps, 0.0, m_fastest_mps); }

/// Of frame B through the water, as the memory counts it; nothing remembers surge.
Six SeaMotion::velocity(const ShipMotion& m) const {
    return {0.0,
            m.sway_mps,
            m.heaveRate_mps + ahead(m.surge_mps) * m.pitch_rad,
            m_ownsRoll ? 0.0 : m.rollRate_radps,
            m.pitchRate_radps,
            m.yawRate_radps};
}

/// On a hull whose roll is the tables': without radiated waves.
double SeaMotion::roll_Nm(const ShipMotion& m, const Acting& acting) const {
    const ViscousRoll damping = m_rollDamping.value_or(m_hull->viscousRollAt(ahead(m.surge_mps)));
    const double p = m.rollRate_radps;
    return acting.model.heelAtBo_Nm + acting.external.roll_Nm - m_hull->restoring(kRoll, kRoll) * m.roll_rad -
           m_hull->mass(kRoll, kSway) * m.surge_mps * m.yawRate_radps -
           (damping.linear_Nms + damping.quadratic_Nms2 * std::abs(p)) * p;
}

SeaMotion::Three SeaMotion::lateral(const ShipMotion& m, const Water& water, const Acting& acting) const {
    const PlanarAcceleration& a = acting.model;
    const Matrix6 &slow = m_hull->memory.slowAddedMass(), &slowEnd = m_hull->memory.slowEndMass();
    const double U = ahead(m.surge_mps), v = m.sway_mps, r = m.yawRate_radps;
    Six f{};
    for (const std::size_t i : kLateral)
        f[i] = m_slow(i, kSway) * a.sway_mps2 + m_slow(i, kYaw) * a.yaw_radps2 + acting.waves.first[i];
    if (!m_ownsRoll) f[kRoll] = roll_Nm(m, acting) + acting.waves.first[kRoll];
    f[kYaw] -= U * (water.momentum[kSway] - slow(kSway, kSway) * v - slow(kSway, kYaw) * r);
    // The model is asked at the velocity through the moving water; the waves' yaw moment already holds what
    // the hull's added mass makes of that movement at speed.
    f[kYaw] -= U * (m_hull->addedMass(kSway, kSway) + slow(kSway, kSway)) * acting.waves.waterSway_mps;
    for (const std::size_t i : kLateral) {
        f[i] -= water.kept[i];
        if (m_hull->transomTerms) f[i] -= U * (water.end[i] - slowEnd(i, kSway) * v - slowEnd(i, kYaw) * r);
    }
    return {f[kSway], m_ownsRoll ? a.roll_radps2 : f[kRoll], f[kYaw]};
}

SeaMotion::Three SeaMotion::vertical(const ShipMotion& m, const Water& water, const Acting& acting) const {
    const Matrix6 &A = m_hull->addedMass, &C = m_hull->restoring;
    const Six &first = acting.waves.first, &v = water.velocity;
    const double U = ahead(m.surge_mps), passing = U * m.pitchRate_radps;
    const double heave_N = first[kHeave] + acting.external.heave_N - C(kHeave, kHeave) * m.down_m -
                           C(kHeave, kPitch) * m.pitch_rad - water.kept[kHeave] -
                           A(kHeave, kHeave) * passing - U * water.end[kHeave];
    const double direct_Ns = A(kHeave, kHeave) * v[kHeave] + A(kHeave, kPitch) * v[kPitch];
    const double pitch_Nm = first[kPitch] + acting.external.pitch_Nm - C(kPitch, kHeave) * m.down_m -
                            C(kPitch, kPitch) * m.pitch_rad - water.kept[kPitch] -
                            A(kPitch, kHeave) * passing + U * (direct_Ns + water.momentum[kHeave]) -
                            U * water.end[kPitch];
    return {m_slow(kSurge, kSurge) * acting.model.surge_mps2 + first[kSurge], heave_N, pitch_Nm};
}

Load SeaMotion::holding(double down_m, double pitch_rad, double surge_mps) const {
    const Matrix6& C = m_hull->restoring;
    const double U = ahead(surge_mps), through_mps = U * pitch_rad;
    const double added_kg = m_slow(kHeave, kHeave) - m_hull->mass(kHeave, kHeave);
    Load load;
    load.heave_N = C(kHeave, kHeave) * down_m + C(kHeave, kPitch) * pitch_rad;
    load.pitch_Nm = C(kPitch, kHeave) * down_m + C(kPitch, kPitch) * pitch_rad - U * added_kg * through_mps;
    if (m_hull->transomTerms) {
        const Matrix6& end = m_hull->memory.slowEndMass();
        load.heave_N += U * end(kHeave, kHeave) * through_mps;
        load.pitch_Nm += U * end(kPitch, kHeave) * through_mps;
    }
    return load;
}

SeaMotion::Rate SeaMotion::rate(const MovingShip& ship, const PlanarAcceleration& model, const Load& external,
                                const WaveForces& waves) const {
    const RadiationMemory& memory = m_hull->memory;
    Water water;
    water.velocity = velocity(ship.motion);
    Rate rate;
    rate.water = memory.rate(ship.water, water.velocity);
    water.kept = memory.momentum(rate.water);
    water.momentum = memory.momentum(ship.water);
    if (m_hull->transomTerms) water.end = memory.endMomentum(ship.water, water.velocity);
    const Acting acting{model, external, waves};
    const Three across = lateral(ship.motion, water, acting), upright = vertical(ship.motion, water, acting);
    for (std::size_t i = 0; i < 3; ++i) {
        rate.acceleration[kLateral[i]] = row(m_lateral[i], across);
        rate.acceleration[kVertical[i]] = row(m_vertical[i], upright);
    }
    return rate;
}

}  // namespace sagara::core
