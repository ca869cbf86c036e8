#include "core/seakeeping/TimeDomain.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

using Complex = std::complex<double>;
constexpr auto kValues = static_cast<int>(HullMotion::kValues);
using Vector = Eigen::Matrix<double, kValues, 1>;
using Square = Eigen::Matrix<double, kValues, kValues>;

HullMotion classicalStep(const HullMotion& x, double dt_s, const auto& rate) {
    const HullMotion k1 = rate(x, 0.0), k2 = rate(x + 0.5 * dt_s * k1, 0.5 * dt_s),
                     k3 = rate(x + 0.5 * dt_s * k2, 0.5 * dt_s), k4 = rate(x + dt_s * k3, dt_s);
    return x + (dt_s / 6.0) * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
}

/// One hull in one regular wave of unit phase at the mean place of Bo.
struct Run {
    const FloatingHull& hull;
    Complex6 force;  ///< in this wave, not per metre
    double omega_radps;
    double speed_mps;
    ViscousRoll roll;
    int steps;  ///< of one period

    /// After one period; the first harmonic on the way, if wanted.
    HullMotion through(HullMotion x, Complex6* harmonic = nullptr) const {
        const double dt_s = kTwoPi / omega_radps / steps;
        std::array<Complex, 6> sum{};
        for (int n = 0; n < steps; ++n) {
            const Complex turn = std::polar(1.0, kTwoPi * n / steps);
            for (std::size_t i = 0; i < 6; ++i) sum[i] += x.displacement(i) * std::conj(turn);
            const auto rate = [&](const HullMotion& y, double later_s) {
                const Complex now = turn * std::polar(1.0, omega_radps * later_s);
                Six f;
                for (std::size_t i = 0; i < 6; ++i) f[i] = (force[i] * now).real();
                return hull.rate(y, f, speed_mps, roll);
            };
            x = classicalStep(x, dt_s, rate);
        }
        if (harmonic != nullptr)
            for (std::size_t i = 0; i < 6; ++i) harmonic->set(i, 2.0 / steps * sum[i]);
        return x;
    }
};

Vector asVector(const HullMotion& m) { return Eigen::Map<const Vector>(m.value.data()); }

HullMotion asMotion(const Vector& v) {
    HullMotion m;
    Eigen::Map<Vector>(m.value.data()) = v;
    return m;
}

/// The first harmonic of the motion that repeats.
Complex6 repeatedMotion(const Run& run, double amplitude_m) {
    // Motions nothing holds may begin anywhere: of all beginnings the shortest.
    Vector start = Vector::Zero();
    for (int iteration = 0; iteration < 12; ++iteration) {
        const Vector after = asVector(run.through(asMotion(start)));
        Square J;
        const double small = 1e-4 * amplitude_m;
        for (int j = 0; j < kValues; ++j) {
            Vector moved = start;
            moved(j) += small;
            J.col(j) = (asVector(run.through(asMotion(moved))) - after) / small;
            J(j, j) -= 1.0;
        }
        Eigen::CompleteOrthogonalDecomposition<Square> solver;
        solver.setThreshold(1e-9);
        const Vector change = solver.compute(J).solve(start - after);
        start += change;
        if (change.norm() < 1e-6 * start.norm()) break;
    }
    Complex6 harmonic;
    run.through(asMotion(start), &harmonic);
    return harmonic;
}

}  // namespace

TimeDomainHull::TimeDomainHull(const HullForm& form, const TableOptions& options)
    : m_form(form),
      m_tables(makeTables(form, options)),
      m_hull(m_tables, options.transomTerms),
      m_excitation(m_tables) {}

WaveResponse TimeDomainHull::respond(const MetWave& wave, double waveHeight_m) const {
    WaveResponse r;
    r.omega_radps = wave.omega_radps;
    r.encounter_radps = wave.encounter_radps();
    r.lambdaOverL = kTwoPi / wave.waveNumber_radpm() / m_form.lengthBp_m;
    const double unit_radps = std::sqrt(kGravity_mps2 / m_form.lengthBp_m);
    const double omega = std::max(std::abs(r.encounter_radps), 0.02 * unit_radps);
    const bool overtaken = r.encounter_radps < 0.0;
    const double amplitude_m = 0.5 * waveHeight_m;
    const Complex6 perMetre =
        m_excitation.amplitude(wave.waveNumber_radpm(), wave.relativeHeading_rad, wave.speed_mps);
    Complex6 force;
    for (std::size_t i = 0; i < 6; ++i)
        force.set(i, amplitude_m * (overtaken ? std::conj(perMetre[i]) : perMetre[i]));
    constexpr double kFastest = 25.0;  // poles of the memory over unit_radps
    const int steps = std::max(120, static_cast<int>(kTwoPi * kFastest * unit_radps / omega));
    const Run run{m_hull, force, omega, wave.speed_mps, viscousRollAt(m_form, omega, wave.speed_mps), steps};
    Complex6 motion = repeatedMotion(run, amplitude_m);
    r.rollAmplitude_rad = std::abs(motion[3]);
    for (std::size_t i = 0; i < 6; ++i) motion.set(i, motion[i] / amplitude_m);
    r.atGravity = atGravity(m_form, wave, motion);
    return r;
}

}  // namespace sagara::core
