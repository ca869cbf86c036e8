#include "core/sea/SeaOrder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"
#include "core/sea/SeaState.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

SeaOrder order(SeaSpectrum spectrum, double height_m, double peak_s) {
    SeaOrder o;
    o.spectrum = spectrum;
    o.significantHeight_m = height_m;
    o.peakPeriod_s = peak_s;
    return o;
}

TEST(SeaOrder, StatisticsAreThoseOfTheReferenceTable) {
    for (const test::Row& row : test::readReference("waves/spectra_check.csv")) {
        SeaOrder o = order(row.text("type") == "jonswap" ? SeaSpectrum::Jonswap : SeaSpectrum::Bretschneider,
                           row["Hs"], row["Tp"]);
        o.gamma = row["gamma"];
        const SeaStatistics s = statisticsOf(systemsOf(o));
        EXPECT_NEAR(s.significantHeight_m() / row["Hs_from_m0"], 1.0, 5e-3);
        EXPECT_NEAR(s.meanPeriod_s() / row["T1"], 1.0, 5e-3);
        EXPECT_NEAR(s.zeroUpcrossing_s() / row["Tz"], 1.0, 0.01);  // 2 % on m2, half of it on its root
        EXPECT_NEAR(s.peakPeriod_s / row["Tp"], 1.0, 1e-3);
    }
}

TEST(SeaOrder, FullyDevelopedSeaIsPiersonAndMoskowitzs) {
    for (const test::Row& row : test::readReference("waves/beaufort.csv")) {
        if (row["B"] == 0.0) continue;
        const HeightAndPeak sea = fullyDeveloped(row["V10_empirical"]);
        EXPECT_NEAR(sea.significantHeight_m / row["PM_Hs"], 1.0, 1e-3) << row["B"];
        EXPECT_NEAR(sea.peakPeriod_s / row["PM_Tp"], 1.0, 1e-3) << row["B"];
    }
}

TEST(SeaOrder, IttcSpectraHaveTheHeightAndMeanPeriodAsked) {
    for (const double period_s : {4.0, 7.0, 11.0}) {
        double m0[2] = {}, m1[2] = {};
        for (double w = 0.05; w < 40.0; w += 0.002) {
            const double S[] = {ittc_m2s(w, 3.0, period_s), ittcJonswap_m2s(w, 3.0, period_s)};
            for (int i = 0; i < 2; ++i) m0[i] += S[i] * 0.002, m1[i] += w * S[i] * 0.002;
        }
        for (int i = 0; i < 2; ++i) {  // the printed constants have three digits
            EXPECT_NEAR(4.0 * std::sqrt(m0[i]) / 3.0, 1.0, 0.01);
            EXPECT_NEAR(kTwoPi * m0[i] / m1[i] / period_s, 1.0, 0.01);
        }
        SeaOrder o = order(SeaSpectrum::Ittc, 3.0, 0.0);
        o.meanPeriod_s = period_s;
        EXPECT_NEAR(spectrum_m2s(systemsOf(o), 0.9) / ittc_m2s(0.9, 3.0, period_s), 1.0, 0.002);
    }
}

TEST(SeaOrder, OchiAndHubblesPartsCarryTheHeightBetweenThem) {
    for (const double height_m : {1.0, 4.0, 10.0}) {
        const auto systems = systemsOf(order(SeaSpectrum::OchiHubble, height_m, 0.0));
        ASSERT_EQ(systems.size(), 2u);
        EXPECT_GT(systems[0].peakPeriod_s, systems[1].peakPeriod_s);
        // 0.84^2 + 0.54^2 = 0.997
        EXPECT_NEAR(statisticsOf(systems).significantHeight_m() / height_m, 0.9986, 0.002);
    }
    for (const double w : {0.4, 0.6, 0.9, 2.0}) {  // lambda 1 is Bretschneider's form
        EXPECT_NEAR(ochiHubble_m2s(w, 2.0, 9.0, 1.0) / bretschneider_m2s(w, 2.0, 9.0), 1.0, 1e-12);
    }
}

TEST(SeaOrder, AnyOrderedSeaStandsOnTheLatticeWithItsHeight) {
    const WaveTable table(5, 50.0);
    for (int i = 0; i < kSeaSpectra; ++i) {
        SeaOrder o = order(static_cast<SeaSpectrum>(i), 3.0, 9.0);
        o.meanPeriod_s = 7.0;
        o.wind_mps = 12.0;
        o.law = SpreadingLaw::CosN;
        o.spreading = 2.0;
        SeaState sea{systemsOf(o), {}, {}};
        raiseSea(table, sea);
        double energy_m2 = 0.0, asked_m2 = 0.0;
        const SeaSurface surface(table, sea);
        for (const auto& wave : surface.waves()) energy_m2 += 0.5 * wave.amplitude_m * wave.amplitude_m;
        for (const SeaSystem& s : sea.systems)
            asked_m2 += s.significantHeight_m * s.significantHeight_m / 16.0;
        EXPECT_NEAR(energy_m2 / asked_m2, 1.0, 1e-9) << seaSpectrumName(o.spectrum);
    }
}

TEST(SeaOrder, HalfPlaneSpreadingIsCosineSquaredOverTwoQuarters) {
    EXPECT_NEAR(halfPlaneSpreading_perRad(0.5, 2.0), 2.0 / kPi * std::pow(std::cos(0.5), 2), 1e-12);
    EXPECT_EQ(halfPlaneSpreading_perRad(2.0, 2.0), 0.0);
    double sum = 0.0;
    for (int i = 0; i < 3600; ++i) sum += halfPlaneSpreading_perRad(i * kTwoPi / 3600, 4.0) * kTwoPi / 3600;
    EXPECT_NEAR(sum, 1.0, 1e-6);
}

TEST(SeaOrder, SeaStatesAreWmosTable) {
    for (const test::Row& row : test::readReference("waves/wmo_sea_state.csv")) {
        const int code = static_cast<int>(row["code"]);
        if (row.has("Hs_max")) {
            EXPECT_EQ(wmoSeaState(row["Hs_max"]), code);
            EXPECT_EQ(wmoSeaState(row["Hs_max"] + 0.01), code + 1);
        } else {
            EXPECT_EQ(wmoSeaState(row["Hs_min"] + 5.0), code);
        }
    }
}

TEST(SeaOrder, HighestOfAThousandWavesIs1Point86Heights) {
    const SeaStatistics s = statisticsOf(systemsOf(order(SeaSpectrum::Bretschneider, 2.0, 8.0)));
    EXPECT_NEAR(s.highestOf_m(1000.0) / s.significantHeight_m(), 1.858, 0.001);
}

}  // namespace
}  // namespace sagara::core
