#include "core/sea/Spectrum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Units.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

double ordinate(const test::Row& row, double omega_radps) {
    return row.text("type") == "jonswap" ? jonswap_m2s(omega_radps, row["Hs"], row["Tp"], row["gamma"])
                                         : bretschneider_m2s(omega_radps, row["Hs"], row["Tp"]);
}

TEST(Spectrum, OrdinatesAgreeWithTheReferenceTable) {
    for (const test::Row& row : test::readReference("waves/spectra_check.csv")) {
        const double peak = kTwoPi / row["Tp"];
        EXPECT_NEAR(ordinate(row, peak) / row["S_wp"], 1.0, 1e-3) << row.text("type");
        EXPECT_NEAR(ordinate(row, 0.8 * peak) / row["S_08wp"], 1.0, 1e-3);
        EXPECT_NEAR(ordinate(row, 1.5 * peak) / row["S_15wp"], 1.0, 1e-3);
        EXPECT_NEAR(ordinate(row, 2.5 * peak) / row["S_25wp"], 1.0, 1e-3);
    }
}

TEST(Spectrum, MomentsAgreeWithTheReferenceTable) {
    for (const test::Row& row : test::readReference("waves/spectra_check.csv")) {
        const double peak = kTwoPi / row["Tp"], step = 0.001 * peak;
        double m0 = 0.0, m1 = 0.0;
        for (double omega = 0.3 * peak + step / 2; omega < 30.0 * peak; omega += step) {
            m0 += ordinate(row, omega) * step;
            m1 += ordinate(row, omega) * omega * step;
        }
        EXPECT_NEAR(m0 / row["m0"], 1.0, 5e-3) << row.text("type");
        EXPECT_NEAR(m1 / row["m1"], 1.0, 5e-3);
    }
}

TEST(Spectrum, PeakOverMeanPeriodIsThatOfTheIntegratedSpectrum) {
    for (const double gamma : {1.0, 1.5, 2.5, 3.3, 4.0, 5.0}) {
        double m0 = 0.0, m1 = 0.0;
        for (double omega = 0.0005; omega < 30.0; omega += 0.001) {  // peak at 1 rad/s
            m0 += jonswap_m2s(omega, 1.0, kTwoPi, gamma);
            m1 += jonswap_m2s(omega, 1.0, kTwoPi, gamma) * omega;
        }
        EXPECT_NEAR(peakOverMeanPeriod(gamma) * m0 / m1, 1.0, 0.01) << gamma;
    }
}

TEST(Spreading, CoversOneTurnAndIsSymmetric) {
    for (const double s : {1.0, 4.0, 25.0, 70.0}) {
        double sum = 0.0;
        for (int i = 0; i < 3600; ++i) sum += spreading_perRad(i * kTwoPi / 3600, s) * kTwoPi / 3600;
        EXPECT_NEAR(sum, 1.0, 1e-9) << s;
        EXPECT_DOUBLE_EQ(spreading_perRad(0.7, s), spreading_perRad(-0.7, s));
        EXPECT_NEAR(spreading_perRad(kPi, s), 0.0, 1e-15);
    }
}

}  // namespace
}  // namespace sagara::core
