#include "core/seakeeping/Response.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/seakeeping/Hydrostatics.h"

namespace sagara::core {
namespace {

using Complex = std::complex<double>;
using Matrix6c = Eigen::Matrix<Complex, 6, 6>;
using Vector6c = Eigen::Matrix<Complex, 6, 1>;

Matrix6c impedance(const MotionEquation& e, double omega_radps) {
    Matrix6c Z;
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            const double inertia = e.mass(i, j) + e.radiation.addedMass(i, j);
            Z(static_cast<int>(i), static_cast<int>(j)) = {
                e.restoring(i, j) - omega_radps * omega_radps * inertia,
                omega_radps * e.radiation.damping(i, j)};
        }
    }
    Z(3, 3) += Complex(0.0, omega_radps * e.extraRollDamping_Nms);
    return Z;
}

/// From Bo to the centre of gravity, which lies at (x, 0, z) in frame B, and to the crest there.
Complex6 movedTo(double x_m, double z_m, const Complex6& m, Complex crest) {
    Complex6 moved;
    moved.set(0, (m[0] + z_m * m[4]) / crest);
    moved.set(1, (m[1] + x_m * m[5] - z_m * m[3]) / crest);
    moved.set(2, (m[2] - x_m * m[4]) / crest);
    for (std::size_t i = 3; i < 6; ++i) moved.set(i, m[i] / crest);
    return moved;
}

}  // namespace

Complex6 solved(const MotionEquation& equation, double omega_radps, const Complex6& force) {
    Vector6c f;
    for (std::size_t i = 0; i < 6; ++i) f(static_cast<int>(i)) = force[i];
    const Vector6c x = impedance(equation, omega_radps).partialPivLu().solve(f);
    Complex6 motion;
    for (std::size_t i = 0; i < 6; ++i) motion.set(i, x(static_cast<int>(i)));
    return motion;
}

HullResponse::HullResponse(const HullForm& form, const TableOptions& options)
    : m_form(form),
      m_options(options),
      m_hull(stripHullOf(form)),
      m_lateral(m_hull),
      m_ikeda(ikedaShipOf(form)),
      m_mass(massMatrix(form)),
      m_restoring(restoringMatrix(form)) {}

WaveResponse HullResponse::respond(const MetWave& wave, double waveHeight_m) const {
    WaveResponse r;
    r.omega_radps = wave.omega_radps;
    r.encounter_radps = wave.encounter_radps();
    r.lambdaOverL = kTwoPi / wave.waveNumber_radpm() / m_form.lengthBp_m;
    // Where ship and wave go along together nothing oscillates: as near to it as the equations hold.
    const double least_radps = 0.02 * std::sqrt(kGravity_mps2 / m_form.lengthBp_m);
    const double omega = std::max(std::abs(r.encounter_radps), least_radps);
    const HullFlow flow = flowAbout(m_hull, omega);
    Complex6 force = froudeKrylovForce(m_hull, wave);
    const Complex6 scattered = diffractionForce(m_hull, flow, wave, m_options.transomTerms);
    // A wave overtaken is met backwards in time: the conjugate, at the positive frequency.
    const bool overtaken = r.encounter_radps < 0.0;
    for (std::size_t i = 0; i < 6; ++i) {
        const Complex sum = force[i] + scattered[i];
        force.set(i, overtaken ? std::conj(sum) : sum);
    }
    MotionEquation equation{
        m_mass, radiationAt(m_lateral.of(m_hull, flow), omega, wave.speed_mps, m_options.transomTerms),
        m_restoring, 0.0};
    Complex6 motion;
    double roll_rad = 2.0 * kDegree_rad;
    for (int i = 0; i < 40; ++i) {
        equation.extraRollDamping_Nms =
            m_form.addedRollDamping_Nms + viscousRollDamping_Nms(m_ikeda, m_form.waterDensity_kgpm3,
                                                                 m_hull.volume_m3, roll_rad, omega,
                                                                 wave.speed_mps);
        motion = solved(equation, omega, force);
        const double next_rad = 0.5 * waveHeight_m * std::abs(motion[3]);
        if (std::abs(next_rad - roll_rad) < 1e-5 * roll_rad) break;
        roll_rad = 0.5 * (roll_rad + next_rad);
    }
    r.rollAmplitude_rad = roll_rad;
    r.atGravity = atGravity(m_form, wave, motion);
    return r;
}

Complex6 atGravity(const HullForm& form, const MetWave& wave, const Complex6& atBo) {
    const double phase = wave.waveNumber_radpm() * form.gravityForward_m * std::cos(wave.relativeHeading_rad);
    const Complex crest = std::polar(1.0, wave.encounter_radps() < 0.0 ? phase : -phase);
    return movedTo(form.gravityForward_m, form.draught_m - form.gravityHeight_m, atBo, crest);
}

FreeRoll::FreeRoll(const HullForm& form)
    : FreeRoll(form, stripHullOf(form), LateralRadiation(stripHullOf(form))) {}

FreeRoll::FreeRoll(const HullForm& form, const StripHull& hull, const LateralRadiation& lateral)
    : m_ikeda(ikedaShipOf(form)),
      m_waterDensity_kgpm3(form.waterDensity_kgpm3),
      m_volume_m3(hull.volume_m3),
      m_added_Nms(form.addedRollDamping_Nms) {
    MotionEquation equation{massMatrix(form), {}, restoringMatrix(form), 0.0};
    const double stiffness = equation.restoring(3, 3);
    if (stiffness <= 0.0) return;
    RollMode& mode = m_undamped;
    mode.omega_radps = std::sqrt(stiffness / (1.2 * equation.mass(3, 3)));
    double inertia = 0.0;
    for (int i = 0; i < 8; ++i) {
        const double omega = mode.omega_radps;
        equation.radiation = radiationAt(lateral.of(hull, flowAbout(hull, omega)), omega, 0.0, false);
        Matrix6c Z = impedance(equation, omega);
        const Complex own = 1.0 / Z.inverse()(3, 3);  // the rest follows without being pushed
        mode.potential_Nms = own.imag() / omega;
        inertia = (stiffness - own.real()) / (omega * omega);
        mode.omega_radps = std::sqrt(stiffness / inertia);
    }
    m_critical_Nms = 2.0 * std::sqrt(stiffness * inertia);
}

RollMode FreeRoll::at(double amplitude_rad) const {
    RollMode mode = m_undamped;
    if (m_critical_Nms == 0.0) return mode;
    mode.viscous_Nms = m_added_Nms + viscousRollDamping_Nms(m_ikeda, m_waterDensity_kgpm3, m_volume_m3,
                                                            amplitude_rad, mode.omega_radps, 0.0);
    mode.dampingRatio = (mode.potential_Nms + mode.viscous_Nms) / m_critical_Nms;
    return mode;
}

}  // namespace sagara::core
