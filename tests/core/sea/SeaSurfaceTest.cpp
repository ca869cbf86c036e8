#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <set>

#include "core/base/Archive.h"
#include "core/base/Random.h"
#include "core/base/Units.h"
#include "core/sea/Beaufort.h"
#include "core/sea/Dispersion.h"
#include "core/sea/SeaState.h"

namespace sagara::core {
namespace {

SeaState seaOf(const WaveTable& table, std::vector<SeaSystem> systems) {
    SeaState sea{std::move(systems), {}, {}};
    raiseSea(table, sea);
    return sea;
}

const WaveSystem kSwell{1.0, 12.0, 3.3, 45.0 * kDegree_rad, 25.0};

/// Four times the standard deviation of the surface over many places and times.
double measuredHs_m(const SeaSurface& surface, int samples) {
    Random random(99);
    double sum2 = 0.0;
    for (int i = 0; i < samples; ++i) {
        const NorthEast p{1200.0 * random.uniform(), 1200.0 * random.uniform()};
        const double z =
            surface.elevation_m(p, SimTime::fromSeconds(static_cast<std::int64_t>(random.next() % 10'000)));
        sum2 += z * z;
    }
    return 4.0 * std::sqrt(sum2 / samples);
}

TEST(SeaSurface, SignificantHeightIsWithin3PercentAtEveryBeaufortNumber) {
    const WaveTable table(3, kDeep_m);
    for (const int number : {1, 3, 5, 7, 9, 12}) {
        const auto wind = windSea(windOfBeaufort_mps(number), 0.6, Exposure::Ocean);
        const SeaSurface surface(table, seaOf(table, {*wind}));
        double exact_m2 = 0.0;
        for (const auto& wave : surface.waves()) exact_m2 += 0.5 * wave.amplitude_m * wave.amplitude_m;
        EXPECT_NEAR(4.0 * std::sqrt(exact_m2) / wind->significantHeight_m, 1.0, 1e-9) << number;
        // 3 % is the figure asked for; 4000 independent samples give the variance to 2.2 %, the height to 1.1
        // %
        EXPECT_NEAR(measuredHs_m(surface, 4000) / wind->significantHeight_m, 1.0, 0.03) << number;
    }
}

TEST(SeaSurface, TwoSystemsAddTheirEnergies) {
    const WaveTable table(5, 20.0);
    const auto wind = windSea(windOfBeaufort_mps(4), 0.6, Exposure::Inshore);
    const SeaSurface surface(table, seaOf(table, {*wind, kSwell}));
    double energy_m2 = 0.0;
    for (const auto& wave : surface.waves()) energy_m2 += 0.5 * wave.amplitude_m * wave.amplitude_m;
    EXPECT_NEAR(16.0 * energy_m2, std::pow(wind->significantHeight_m, 2) + 1.0, 1e-9);
}

TEST(SeaState, ActiveComponentsKeepAtLeast95PercentOfTheLongWavesEnergy) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const WaveTable table(seed, 20.0);
        for (int number = 1; number <= 12; ++number) {
            const auto wind = windSea(windOfBeaufort_mps(number), 0.6, Exposure::Inshore);
            std::vector<double> energy_m2(table.components().size(), 0.0);
            table.addEnergy(*wind, energy_m2);
            table.addEnergy(kSwell, energy_m2);
            const double total = std::accumulate(energy_m2.begin(), energy_m2.end(), 0.0);
            double kept = 0.0;
            for (const auto i : seaOf(table, {*wind, kSwell}).active) kept += energy_m2[i];
            EXPECT_GE(kept / total, 0.95) << "Beaufort " << number;
        }
    }
}

TEST(SeaState, TheSurfaceFeltIsTheSurfaceDrawn) {
    const WaveTable table(11, 20.0);
    const SeaState sea = seaOf(table, {kSwell});
    const SimTime time = SimTime::fromSeconds(1234);
    auto waves = std::make_unique<ActiveWaves>();
    activeWaves(table, sea, time, *waves);
    SeaSurface drawn(table, sea);
    double short_m2 = 0.0;
    for (const auto& wave : drawn.waves()) {
        if (wave.component.band == 2) short_m2 += 0.5 * wave.amplitude_m * wave.amplitude_m;
    }
    EXPECT_LT(short_m2, 1e-3 / 16.0);  // a swell has no skin worth naming: 0.1 % of its energy
    Random random(4);
    double worst_m = 0.0;
    for (int i = 0; i < 100; ++i) {
        const NorthEast p{4000.0 * random.uniform(), 4000.0 * random.uniform()};
        worst_m = std::max(worst_m, std::abs(longElevation_m(*waves, p) - drawn.elevation_m(p, time)));
    }
    EXPECT_LT(worst_m, 5.0 * std::sqrt(short_m2) + 1e-9);
}

TEST(WaveTable, EveryComponentIsAPointOfItsLatticeAndNoPointCarriesTwo) {
    const WaveTable table(1, 20.0);
    std::set<std::tuple<int, long, long>> seen;
    for (const WaveComponent& c : table.components()) {
        const double step = kWaveBands[c.band].step_radpm();
        const double i = c.kNorth_radpm / step, j = c.kEast_radpm / step;
        EXPECT_NEAR(i, std::round(i), 1e-9);
        EXPECT_NEAR(j, std::round(j), 1e-9);
        EXPECT_LT(std::max(std::abs(i), std::abs(j)), kLatticeSize / 2);
        EXPECT_TRUE(seen.emplace(c.band, std::lround(i), std::lround(j)).second);
        EXPECT_NEAR(c.omega_radps,
                    angularFrequency_radps(std::hypot(c.kNorth_radpm, c.kEast_radpm), 20.0, kGravity_mps2),
                    1e-12);
    }
}

TEST(WaveTable, MeanDirectionOfTravelIsTheOneAsked) {
    const WaveTable table(8, 20.0);
    for (int degrees = 0; degrees < 360; degrees += 30) {
        WaveSystem swell = kSwell;
        swell.wavesTo_rad = degrees * kDegree_rad;
        std::vector<double> energy_m2(table.components().size(), 0.0);
        table.addEnergy(swell, energy_m2);
        NorthEast mean;
        for (std::size_t i = 0; i < energy_m2.size(); ++i) {
            const WaveComponent& c = table.components()[i];
            const NorthEast k{c.kNorth_radpm, c.kEast_radpm};
            mean = mean + (energy_m2[i] / length(k)) * k;
        }
        // A 150 m wave is eight lattice steps long, so single points are 7 deg apart; the mean of a train is
        // closer.
        EXPECT_NEAR(std::remainder(bearing_rad({}, mean) - swell.wavesTo_rad, kTwoPi), 0.0,
                    3.0 * kDegree_rad);
    }
}

TEST(SeaState, SameSeedGivesTheSameBytesAndAnotherSeedAnotherSea) {
    const WaveTable a(1, 20.0), b(1, 20.0), c(2, 20.0);
    EXPECT_EQ(archiveHash(seaOf(a, {kSwell})), archiveHash(seaOf(b, {kSwell})));
    EXPECT_EQ(SeaSurface(a, seaOf(a, {kSwell})).elevation_m({1, 2}, {}),
              SeaSurface(b, seaOf(b, {kSwell})).elevation_m({1, 2}, {}));
    EXPECT_NE(SeaSurface(a, seaOf(a, {kSwell})).elevation_m({1, 2}, {}),
              SeaSurface(c, seaOf(c, {kSwell})).elevation_m({1, 2}, {}));
}

TEST(SeaState, NoSystemsNoWaves) {
    const WaveTable table(1, 20.0);
    const SeaState calm = seaOf(table, {});
    EXPECT_TRUE(calm.active.empty());
    EXPECT_EQ(SeaSurface(table, calm).elevation_m({3, 4}, SimTime::fromSeconds(5)), 0.0);
}

}  // namespace
}  // namespace sagara::core
