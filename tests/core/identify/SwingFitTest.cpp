#include "core/identify/SwingFit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "NoisyTrials.h"
#include "core/base/Config.h"
#include "core/base/Units.h"
#include "core/identify/Decay.h"
#include "core/identify/FittedDocument.h"
#include "core/identify/TrialShip.h"
#include "core/identify/WaveDrive.h"
#include "core/motion/RungeKutta.h"
#include "tests/support/Assets.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

Vessel shipped(const std::string& id) {
    return loadVessel(id, test::readAsset("vessels/" + id + ".json")).value();
}

struct Roll {
    double angle = 0.0, rate = 0.0;
    friend Roll operator+(const Roll& a, const Roll& b) { return {a.angle + b.angle, a.rate + b.rate}; }
    friend Roll operator*(double s, const Roll& a) { return {s * a.angle, s * a.rate}; }
};

constexpr double kW = 0.9, kZeta = 0.03, kD = 0.5;  // a patrol vessel: period 7 s
Roll rollRate(const Roll& r, double slope_rad) {
    return {r.rate,
            kW * kW * (slope_rad - r.angle) - 2.0 * kZeta * kW * r.rate - kD * r.rate * std::abs(r.rate)};
}

std::string row(std::initializer_list<double> values) {
    std::string text;
    for (const double v : values) {
        if (!text.empty()) text += ',';
        text += config::formatNumber(v);
    }
    text += '\n';
    return text;
}

/// A decay of the equation itself with 0.1 deg of noise: five per cent is about three deviations of it.
TEST(SwingFit, DecayGivesLinearAndQuadraticDamping) {
    test::Noise noise(5);
    std::string csv = "# kind: decay\ntime_s,roll_deg\n";
    Roll r{15.0 * kDegree_rad, 0.0};
    constexpr double kStep_s = 0.1;
    for (int i = 0; i < 900; ++i) {
        csv += row({i * kStep_s, r.angle / kDegree_rad + 0.1 * noise()});
        r = rk4Step(r, kStep_s, [](const Roll& x) { return rollRate(x, 0.0); });
    }
    const Vessel ship = shipped("patrol51");
    const auto fit = fitSwing(ship, {readSeaTrial("decay.csv", csv).value()}, Channel::Roll);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->frequency_radps / kW, 1.0, 0.002);
    EXPECT_NEAR(fit->linear / kZeta, 1.0, 0.05);
    EXPECT_NEAR(fit->quadratic / kD, 1.0, 0.1);
    EXPECT_TRUE(fit->told());
    EXPECT_NEAR(fit->rms, 0.1 * kDegree_rad, 0.02 * kDegree_rad);
    // As a moment it takes as much from a swing: inertia times the equation's own terms.
    const Hull& hull = ship.hull;
    const double inertia_kgm2 = hull.mass_kg() * kGravity_mps2 * hull.metacentricHeight_m /
                                (fit->frequency_radps * fit->frequency_radps);
    const RollMoment moment = rollMomentOf(*fit, hull);
    EXPECT_NEAR(moment.linear_Nms / (2.0 * kZeta * kW * inertia_kgm2), 1.0, 0.05);
    EXPECT_NEAR(moment.quadratic_Nms2 / (kD * inertia_kgm2), 1.0, 0.1);
}

/// The 1:68 model of KVLCC2, extreme angles of every half swing. The file: period 2 %, damping 25 %.
TEST(SwingFit, MeasuredDecayOfKvlcc2) {
    std::string csv = "# kind: decay\ntime_s,roll_deg\n";
    double side = 1.0;
    for (const test::Row& r : test::readReference("seakeeping/kvlcc2_roll_decay_0kn.csv")) {
        csv += row({r["time"], side * r["roll_abs"]});
        side = -side;
    }
    const Vessel ship = shipped("kvlcc2");
    const auto fit = fitSwing(ship, {readSeaTrial("decay.csv", csv).value()}, Channel::Roll);
    ASSERT_TRUE(fit);
    std::printf("zeta %.5f +- %.5f, d %.3f +- %.3f, at %.2f deg %.5f +- %.5f, left %.3f deg\n", fit->linear,
                fit->linearDeviation, fit->quadratic, fit->quadraticDeviation, fit->amplitude / kDegree_rad,
                fit->equivalent(fit->amplitude), fit->equivalentDeviation(fit->amplitude),
                fit->rms / kDegree_rad);
    EXPECT_NEAR(kTwoPi / fit->frequency_radps / 20.87, 1.0, 0.02);
    EXPECT_NEAR(fit->equivalent(9.0 * kDegree_rad) / 0.0085, 1.0, 0.25);
    EXPECT_NEAR(fit->equivalent(6.0 * kDegree_rad) / 0.0058, 1.0, 0.25);
    const std::string text =
        fittedDocument(test::readAsset("vessels/kvlcc2.json"), {}, fitManoeuvres(ship, {}, {}), {*fit});
    const auto fitted = loadVessel("fitted", text);
    ASSERT_TRUE(fitted) << fitted.error().text();
    EXPECT_EQ(fitted->seakeeping.provenance.quality, Quality::Fitted);
    // The document's ship rolls with the measured period.
    TrialShip rolls(*fitted);
    const Trial decay = runDecay(rolls, {.dof = Decay::Dof::Roll, .start = 0.1});
    EXPECT_NEAR(*decay.measure("period_s") / 20.87, 1.0, 0.02);
}

/// One wave of a sea: height and where it begins.
struct Wave {
    double w_radps, height_m, phase_rad;
};
std::vector<Wave> sea(double peak_radps, double significant_m, std::uint64_t seed) {
    std::vector<Wave> waves;
    test::Noise noise(seed);
    double squares = 0.0;
    for (double w = 0.5 * peak_radps; w < 2.2 * peak_radps; w += 0.017 * peak_radps) {
        const double shape = std::pow(w / peak_radps, -5.0) * std::exp(-1.25 * std::pow(peak_radps / w, 4.0));
        waves.push_back({w, std::sqrt(shape), kTwoPi * noise()});
        squares += 0.5 * shape;
    }
    for (Wave& wave : waves) wave.height_m *= significant_m / 4.0 / std::sqrt(squares);
    return waves;
}

/// Half an hour at rest in beam seas, the wave measured 5 m to the side of the ship and with noise. What a
/// patrol vessel's beam and draught leave of each slope is not given away: the tolerances hold that too.
TEST(SwingFit, MotionLogGivesRollDamping) {
    const Vessel ship = shipped("patrol51");
    const std::vector<Wave> waves = sea(0.8, 1.5, 23);
    test::Noise noise(29);
    const auto sum = [&](double t_s, double offset_m, auto&& of) {
        double all = 0.0;
        for (const Wave& wave : waves) {
            const double k = wave.w_radps * wave.w_radps / kGravity_mps2;
            all += of(wave.height_m, k, wave.w_radps * t_s + wave.phase_rad - k * offset_m);
        }
        return all;
    };
    const auto slope = [&](double t_s) {
        return sum(t_s, 0.0, [&](double a, double k, double phase) {
            const double felt = std::exp(-0.5 * k * ship.hull.draught_m) *
                                (1.0 - std::pow(0.5 * k * ship.hull.beam_m, 2) / 10.0);
            return felt * k * a * std::sin(phase);
        });
    };
    std::string csv = "# kind: motion-log\n# wave_heading_deg: 90\ntime_s,roll_deg,wave_m\n";
    Roll r;
    constexpr double kStep_s = 0.25;
    for (double t = -300.0; t < 1800.0; t += kStep_s) {
        if (t >= 0.0) {
            const double wave =
                sum(t, 5.0, [](double a, double, double phase) { return a * std::cos(phase); });
            csv += row({t, r.angle / kDegree_rad + 0.2 * noise(), wave + 0.02 * noise()});
        }
        r = rk4Step(r, kStep_s, [&](const Roll& x) { return rollRate(x, slope(t + 0.5 * kStep_s)); });
    }
    const auto fit = fitSwing(ship, {readSeaTrial("log.csv", csv).value()}, Channel::Roll);
    ASSERT_TRUE(fit);
    std::printf(
        "w %.4f (0.9) +- %.4f, zeta %.4f (0.03) +- %.4f, d %.3f (0.5) +- %.3f, amplitude %.2f deg, left %.2f "
        "deg\n",
        fit->frequency_radps, fit->frequencyDeviation_radps, fit->linear, fit->linearDeviation,
        fit->quadratic, fit->quadraticDeviation, fit->amplitude / kDegree_rad, fit->rms / kDegree_rad);
    EXPECT_NEAR(fit->frequency_radps / kW, 1.0, 0.01);
    const double a = fit->amplitude, should = kZeta + 4.0 / (3.0 * kPi) * kD * a;
    EXPECT_NEAR(fit->equivalent(a) / should, 1.0, 0.1);
    EXPECT_TRUE(fit->told());
}

/// Ten minutes into head seas at 5 m/s: a spring in waves as core/motion has it, the wave under midship known
/// to 0.02 m. Fifteen per cent: heave is damped so much that its own period hardly shows.
TEST(SwingFit, MotionLogGivesHeaveDamping) {
    const Vessel ship = shipped("patrol51");
    const double U = 5.0, zeta = 0.45, added = ship.seakeeping.heaveAddedMassRatio;
    const double w = std::sqrt(ship.hull.waterDensity_kgpm3 * kGravity_mps2 * ship.hull.waterplaneArea_m2() /
                               (ship.hull.mass_kg() * (1.0 + added)));
    const std::vector<Wave> waves = sea(1.0, 1.5, 31);
    test::Noise noise(37);
    const auto each = [&](double t_s, auto&& visit) {
        for (const Wave& wave : waves) {
            const double k = wave.w_radps * wave.w_radps / kGravity_mps2, met = wave.w_radps + k * U,
                         x = 0.5 * k * ship.hull.lengthBp_m;
            visit(wave.height_m, met, met * t_s + wave.phase_rad,
                  std::exp(-0.5 * k * ship.hull.draught_m) * std::sin(x) / x);
        }
    };
    std::string csv =
        "# kind: motion-log\n# wave_heading_deg: 180\n# approach_mps: 5\ntime_s,heave_m,wave_m\n";
    Roll z;  // heave, upward
    constexpr double kStep_s = 0.1;
    for (double t = -60.0; t < 600.0; t += kStep_s) {
        double height = 0.0, push = 0.0;
        each(t, [&](double a, double, double phase, double) { height += a * std::cos(phase); });
        each(t + 0.5 * kStep_s, [&](double a, double met, double phase, double felt) {
            push += a * felt *
                    ((w * w - added / (1.0 + added) * met * met) * std::cos(phase) -
                     2.0 * zeta * w * met * std::sin(phase));
        });
        if (t >= 0.0) csv += row({t, -z.angle + 0.02 * noise(), height + 0.02 * noise()});
        z = rk4Step(z, kStep_s, [&](const Roll& x) {
            return Roll{x.rate, push - w * w * x.angle - 2.0 * zeta * w * x.rate};
        });
    }
    const auto fit = fitSwing(ship, {readSeaTrial("log.csv", csv).value()}, Channel::Heave);
    ASSERT_TRUE(fit);
    std::printf("heave: w %.3f (%.3f), zeta %.3f (0.45) +- %.3f, left %.3f m\n", fit->frequency_radps, w,
                fit->linear, fit->linearDeviation, fit->rms);
    EXPECT_NEAR(fit->linear / zeta, 1.0, 0.15);
    EXPECT_EQ(fit->quadratic, 0.0);
    EXPECT_TRUE(fit->told());
}

TEST(SwingFit, EncounteredWaves) {
    const double U = 8.0, w = 0.7, k = w * w / kGravity_mps2;
    for (const double heading : {0.0, 60.0, 90.0, 135.0, 180.0}) {
        const double met = w - k * U * std::cos(heading * kDegree_rad);
        if (met > 0.0 && 2.0 * w * U * std::cos(heading * kDegree_rad) < kGravity_mps2) {
            EXPECT_NEAR(encounteredWaveNumber_radpm(met, U, heading * kDegree_rad) / k, 1.0, 1e-9) << heading;
        }
    }
}

}  // namespace
}  // namespace sagara::core
