#include "core/seakeeping/TimeDomain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ReferenceHull.h"
#include "core/base/Units.h"
#include "core/seakeeping/MakeTables.h"
#include "core/seakeeping/StripTheory.h"
#include "core/seakeeping/TableCache.h"

namespace sagara::core {
namespace {

/// S175 up to Froude 0.3: asymmetric fore and aft, with a transom of no area.
const TimeDomainHull& containerShip() {
    static const TimeDomainHull hull(referenceHull("s175"), {0.3, true});
    return hull;
}

constexpr std::size_t kPairs[][2] = {{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {1, 3}, {1, 5}, {2, 4}, {3, 5}};

class RadiationMemoryOf : public ::testing::TestWithParam<const char*> {};

TEST_P(RadiationMemoryOf, AnswersWithTheAddedMassAndDampingOfTheTables) {
    const SeakeepingTables t = makeTables(referenceHull(GetParam()), {0.0, true});
    const RadiationMemory memory(t);
    for (const auto& [i, j] : kPairs) {
        double worstMass = 0.0, worstDamping = 0.0;
        Six most{};
        for (std::size_t n = 0; n < t.omega_radps.size(); ++n) {
            const Radiation r = memory.radiationAt(t.omega_radps[n]);
            most[i] = std::max(most[i], t.radiation[n].damping(i, i));
            most[j] = std::max(most[j], t.radiation[n].damping(j, j));
            worstMass = std::max(worstMass, std::abs(r.addedMass(i, j) - t.radiation[n].addedMass(i, j)));
            worstDamping = std::max(worstDamping, std::abs(r.damping(i, j) - t.radiation[n].damping(i, j)));
        }
        const double mass = std::sqrt(t.addedMassInfinite(i, i) * t.addedMassInfinite(j, j));
        EXPECT_LT(worstMass, 0.03 * mass) << i << j;
        EXPECT_LT(worstDamping, 0.03 * std::sqrt(most[i] * most[j])) << i << j;
    }
}

TEST_P(RadiationMemoryOf, GivesNoEnergy) {
    const SeakeepingTables t = makeTables(referenceHull(GetParam()), {0.0, true});
    const RadiationMemory memory(t);
    const double unit = std::sqrt(kGravity_mps2 / t.lengthBp_m);
    for (double w = 0.1; w < 20.0; w *= 1.05) EXPECT_GT(memory.leastDamping(w * unit), -0.01) << w;
}

INSTANTIATE_TEST_SUITE_P(Hulls, RadiationMemoryOf,
                         ::testing::Values("s175", "box_barge100", "wigley_III", "kvlcc2", "dtmb5415"));

TEST(WaveExcitation, IsThatOfTheVeryWave) {
    const HullForm form = referenceHull("s175");
    const StripHull hull = stripHullOf(form);
    const SeakeepingTables& t = containerShip().tables();
    const WaveExcitation excitation(t);
    std::array<double, 6> most{};
    for (const Complex6& f : t.froudeKrylov)
        for (std::size_t i = 0; i < 6; ++i) most[i] = std::max(most[i], std::abs(f[i]));
    const double unit = std::sqrt(kGravity_mps2 / t.lengthBp_m);
    for (const double heading : {0.2, 0.9, 1.6, 2.3, 3.0, 4.4, -0.7}) {
        for (const double omega : {0.62, 1.23, 1.84, 2.51, 3.33}) {
            for (const double froude : {0.0, 0.14, 0.275}) {
                const MetWave wave{omega * unit, heading, froude * std::sqrt(kGravity_mps2 * t.lengthBp_m)};
                const double encounter = std::abs(wave.encounter_radps());
                if (encounter < t.omega_radps.front()) continue;
                const Complex6 fk = froudeKrylovForce(hull, wave),
                               d = diffractionForce(hull, flowAbout(hull, encounter), wave, true);
                const Complex6 f = excitation.amplitude(wave.waveNumber_radpm(), heading, wave.speed_mps);
                for (std::size_t i = 0; i < 6; ++i)
                    EXPECT_NEAR(std::abs(f[i] - fk[i] - d[i]) / most[i], 0.0, 0.035)
                        << heading << ' ' << omega << ' ' << froude << ' ' << i;
            }
        }
    }
}

TEST(WaveExcitation, SumsComponentsAtTheirPlaceAndPhase) {
    const SeakeepingTables& t = containerShip().tables();
    const WaveExcitation excitation(t);
    ActiveWaves waves;
    waves.count = 1;
    waves.kNorth_radpm[0] = 0.03;
    waves.kEast_radpm[0] = -0.02;
    waves.amplitude_m[0] = 1.5;
    waves.omega_radps[0] = 0.6;
    waves.phase_rad[0] = 0.4;
    const double heading = 0.3, k = std::hypot(0.03, 0.02);
    const Six f = excitation.force(waves, {100.0, 50.0}, heading, 3.0, 0.8).first;
    const Complex6 a = excitation.amplitude(k, heading - std::atan2(-0.02, 0.03), 3.0);
    const std::complex<double> turn = std::polar(1.0, -(0.03 * 100.0 - 0.02 * 50.0 + 0.4));
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_NEAR(f[i], 0.8 * 1.5 * (a[i] * turn).real(), 1e-4 * std::abs(a[i])) << i;
}

class TimeDomainOf : public ::testing::TestWithParam<const char*> {};

TEST_P(TimeDomainOf, MeasuresTheResponseOfTheFrequencyDomain) {
    const HullForm form = referenceHull(GetParam());
    const HullResponse frequency(form);
    for (const double froude : {0.0, 0.26}) {
        const double speed_mps = froude * std::sqrt(kGravity_mps2 * form.lengthBp_m);
        const TimeDomainHull time(form, {0.0, true, {speed_mps}});
        for (const double heading_deg : {180.0, 150.0, 90.0, 30.0}) {
            for (const double lambdaOverL : {0.6, 0.8, 1.0, 1.3, 2.0, 3.0}) {
                const double omega = std::sqrt(kGravity_mps2 * kTwoPi / (lambdaOverL * form.lengthBp_m));
                const MetWave wave{omega, heading_deg * kDegree_rad, speed_mps};
                const double height_m = form.lengthBp_m / 50.0;
                const WaveResponse a = time.respond(wave, height_m), b = frequency.respond(wave, height_m);
                for (std::size_t i = 0; i < 6; ++i) {
                    const double unit = i < 3 ? 1.0 : kTwoPi / (lambdaOverL * form.lengthBp_m);
                    const double x = std::abs(a.atGravity[i]) / unit, y = std::abs(b.atGravity[i]) / unit;
                    EXPECT_NEAR(x, y, 0.03 * std::max(y, 0.3))
                        << GetParam() << " Fn " << froude << " heading " << heading_deg << " lambda/L "
                        << lambdaOverL << " motion " << i;
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Hulls, TimeDomainOf,
                         ::testing::Values("s175", "box_barge100", "wigley_III", "kvlcc2", "dtmb5415"));

TEST(TimeDomain, LongWavesCarryTheShipAsACork) {
    const HullForm form = referenceHull("s175");
    const double roll = containerShip().tables().rollFrequency_radps;
    const WaveResponse beam = containerShip().respond({0.1 * roll, 0.5 * kPi, 0.0}, 1.0);
    const double k = kTwoPi / (beam.lambdaOverL * form.lengthBp_m);
    EXPECT_NEAR(std::abs(beam.atGravity[2]), 1.0, 0.01);
    EXPECT_NEAR(std::abs(beam.atGravity[3]) / k, 1.0, 0.01);
    const WaveResponse head = containerShip().respond({0.1, kPi, 0.0}, 1.0);
    const double kHead = kTwoPi / (head.lambdaOverL * form.lengthBp_m);
    EXPECT_NEAR(std::abs(head.atGravity[2]), 1.0, 0.01);
    EXPECT_NEAR(std::abs(head.atGravity[4]) / kHead, 1.0, 0.01);
}

struct OnePlace final : TableCache {
    std::optional<SeakeepingTables> kept;
    std::optional<SeakeepingTables> find(std::uint64_t hash) override {
        return kept && kept->inputHash == hash ? kept : std::nullopt;
    }
    void keep(const SeakeepingTables& tables) override { kept = tables; }
};

TEST(TableCache, KeepsTablesByTheirInput) {
    HullForm form = referenceHull("wigley_III");
    const TableOptions options{0.0, true, {1.0}};
    OnePlace cache;
    const SeakeepingTables made = tablesFor(form, options, &cache);
    ASSERT_TRUE(cache.kept);
    cache.kept->notes.push_back("kept");
    EXPECT_EQ(tablesFor(form, options, &cache).notes, cache.kept->notes);
    form.mass_kg *= 1.1;
    EXPECT_NE(tablesFor(form, options, &cache).inputHash, made.inputHash);
    EXPECT_EQ(tablesFor(referenceHull("wigley_III"), options), made);
}

class MeanForces : public ::testing::Test {
protected:
    static MeanWaveForce at(const SeakeepingTables& t, std::size_t speed, double heading_deg,
                            double lambdaOverL) {
        const double omega = std::sqrt(kGravity_mps2 * kTwoPi / (lambdaOverL * t.lengthBp_m));
        std::size_t n = 0, h = 0;
        while (t.waveOmega_radps[n] < omega) ++n;
        while (t.headings_rad[h] < heading_deg * kDegree_rad - 1e-9) ++h;
        return t.meanForce[t.waveIndex(speed, h, n)];
    }
};

TEST_F(MeanForces, ShortBeamWavesAreThrownBackByTheWholeSide) {
    const SeakeepingTables& t = containerShip().tables();
    const double wall = 0.5 * t.waterDensity_kgpm3 * kGravity_mps2 * t.lengthBp_m;
    const MeanWaveForce f = at(t, 0, 90.0, 0.16);
    // To port in waves from starboard; the ends of the waterline do not face them squarely.
    EXPECT_LT(f.sway_Npm2, -0.75 * wall);
    EXPECT_GT(f.sway_Npm2, -1.1 * wall);
    EXPECT_LT(std::abs(f.surge_Npm2), 0.1 * wall);
}

TEST_F(MeanForces, HeadWavesResistMostWhereTheShipMovesMost) {
    const SeakeepingTables& t = containerShip().tables();
    const double unit = -t.waterDensity_kgpm3 * kGravity_mps2 * t.breadth_m * t.breadth_m / t.lengthBp_m;
    double most = 0.0, lambdaOfMost = 0.0;
    for (double lambda = 0.5; lambda < 2.5; lambda += 0.1) {
        const MeanWaveForce f = at(t, 2, 180.0, lambda);
        EXPECT_GT(f.surge_Npm2 / unit, 0.0) << lambda;
        EXPECT_NEAR(f.sway_Npm2 / unit, 0.0, 1e-6);
        if (f.surge_Npm2 / unit > most) {
            most = f.surge_Npm2 / unit;
            lambdaOfMost = lambda;
        }
    }
    // Trend only: measured peaks of such ships at Froude 0.2 are 6 to 14 near waves of her length.
    EXPECT_GT(most, 5.0);
    EXPECT_LT(most, 16.0);
    EXPECT_NEAR(lambdaOfMost, 1.1, 0.3);
    EXPECT_LT(at(t, 2, 180.0, 3.0).surge_Npm2 / unit, 0.3 * most);
}

}  // namespace
}  // namespace sagara::core
