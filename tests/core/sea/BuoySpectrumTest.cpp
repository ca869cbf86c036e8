#include "core/sea/BuoySpectrum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Angle.h"
#include "core/sea/SeaOrder.h"
#include "core/sea/SeaState.h"
#include "tests/support/Assets.h"

namespace sagara::core {
namespace {

std::vector<BuoySpectrum> records() {
    return loadBuoyRecords("ndbc-41010.json", test::readAsset("waves/ndbc-41010.json")).value();
}

TEST(BuoySpectrum, HeightsAgreeWithTheStationsSummary) {
    const double kWaveHeight_m[] = {0.8, 0.8, 2.4, 1.7, 1.3, 1.1, 1.1, 1.3, 1.3, 0.9, 1.2, 1.2, 1.3};
    const auto all = records();
    ASSERT_EQ(all.size(), std::size(kWaveHeight_m));
    for (std::size_t i = 0; i < all.size(); ++i)  // 0.11 m for all records, README of the data
        EXPECT_NEAR(all[i].significantHeight_m(), kWaveHeight_m[i], 0.11) << all[i].source;
}

TEST(BuoySpectrum, TheSeaMadeOfItHasItsSpectrumHeightAndDirections) {
    const WaveTable table(3, 100.0);
    const auto all = records();
    for (const BuoySpectrum& record : all) {
        const auto systems = record.systems();
        EXPECT_NEAR(statisticsOf(systems).significantHeight_m() / record.significantHeight_m(), 1.0, 0.01);
        for (std::size_t i = 0; i < record.bins.size(); ++i) {
            const BuoySpectrum::Bin& bin = record.bins[i];
            if (bin.energy_m2pHz <= 0.0) continue;
            EXPECT_NEAR(spectrum_m2s(systems, kTwoPi * bin.frequency_Hz) * kTwoPi / bin.energy_m2pHz, 1.0,
                        0.1);
        }
        if (&record != &all[2] && &record != &all[7]) continue;  // the highest, and one of two trains
        SeaState sea{systems, {}, {}};
        raiseSea(table, sea);
        double energy_m2 = 0.0;
        NorthEast flux, asked;
        const SeaSurface surface(table, sea);
        for (const auto& w : surface.waves()) {
            const double e = 0.5 * w.amplitude_m * w.amplitude_m;
            const NorthEast k{w.component.kNorth_radpm, w.component.kEast_radpm};
            energy_m2 += e;
            flux = flux + (e / length(k)) * k;
        }
        for (std::size_t i = 0; i < record.bins.size(); ++i) {
            const BuoySpectrum::Bin& bin = record.bins[i];
            asked = asked + (bin.energy_m2pHz * record.width_Hz(i) * bin.r1) * unitVector(bin.from_rad + kPi);
        }
        EXPECT_NEAR(4.0 * std::sqrt(energy_m2) / record.significantHeight_m(), 1.0, 0.01) << record.source;
        const double turned = std::atan2(flux.east_m, flux.north_m) - std::atan2(asked.east_m, asked.north_m);
        EXPECT_NEAR(wrapPi(turned), 0.0, 4.0 * kPi / 180.0)
            << record.source;  // lattice points are 7 deg apart
    }
}

TEST(BuoySpectrum, SpreadingOfTheStationHasUnitIntegralAndItsMoments) {
    const BuoySpectrum record = records()[2];
    const std::size_t bin = 12;
    double sum = 0.0, first = 0.0;
    for (int i = 0; i < 360; ++i) {
        const double theta = i * kPi / 180.0, part = record.spreading_perRad(bin, theta) * kPi / 180.0;
        sum += part;
        first += part * std::cos(theta - record.bins[bin].from_rad);
    }
    EXPECT_NEAR(sum, 1.0, 1e-9);
    EXPECT_NEAR(first, record.bins[bin].r1, 1e-9);
}

TEST(BuoySpectrum, EveryMistakeOfADocumentIsNamed) {
    const auto bad = loadBuoyRecords("w.json", R"({"document": "waves", "version": 1, "attribution": "x",
        "records": [{"source": "s", "frequency_Hz": [0.1, 0.1, 0.3], "energy_m2pHz": [1, -2, 1],
                     "from_deg": [0, 0], "r1": [0.5, 0.5, 0.5]}]})");
    ASSERT_FALSE(bad);
    EXPECT_EQ(bad.error().size(), 3u) << bad.error().text();
}

}  // namespace
}  // namespace sagara::core
