#include "core/seakeeping/SeakeepingTables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ReferenceHull.h"
#include "core/base/Archive.h"
#include "core/base/Units.h"
#include "core/seakeeping/MakeTables.h"
#include "core/seakeeping/StripTheory.h"

namespace sagara::core {
namespace {

class Tables : public ::testing::Test {
protected:
    static void SetUpTestSuite() {
        s_tables = new SeakeepingTables(makeTables(referenceHull("s175"), {0.2, true}));
    }
    static void TearDownTestSuite() { delete s_tables; }
    static inline SeakeepingTables* s_tables = nullptr;
};

TEST_F(Tables, AreCompleteAndFinite) {
    const SeakeepingTables& t = *s_tables;
    EXPECT_EQ(t.radiation.size(), t.omega_radps.size());
    EXPECT_EQ(t.speeds_mps.size(), 3u);
    EXPECT_EQ(t.viscousRoll.size(), t.speeds_mps.size());
    EXPECT_EQ(t.froudeKrylov.size(), t.headings_rad.size() * t.waveOmega_radps.size());
    EXPECT_EQ(t.diffraction.size(), t.speeds_mps.size() * t.froudeKrylov.size());
    for (const Complex6& f : t.diffraction)
        for (std::size_t i = 0; i < 6; ++i) ASSERT_TRUE(std::isfinite(std::abs(f[i])));
    for (const Radiation& r : t.radiation) {
        for (std::size_t i = 1; i < 6; ++i) {
            EXPECT_GT(r.addedMass(i, i), 0.0);
            EXPECT_GE(r.damping(i, i), -1e-4 * r.addedMass(i, i));
            for (std::size_t j = 0; j < 6; ++j)
                EXPECT_NEAR(r.damping(i, j), r.damping(j, i), 1e-9 * std::abs(r.damping(i, j)) + 1e-6);
        }
    }
}

TEST_F(Tables, SurviveTheArchive) {
    const auto back = fromBytes<SeakeepingTables>(toBytes(*s_tables));
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, *s_tables);
}

TEST_F(Tables, HighestFrequencyIsNearTheInfinite) {
    for (std::size_t i = 1; i < 6; ++i) {
        const double limit = s_tables->addedMassInfinite(i, i);
        // Sway and yaw come to it as the inverse of the wave number does.
        const double band = i == 1 || i == 5 ? 0.2 : 0.08;
        EXPECT_NEAR(s_tables->radiation.back().addedMass(i, i), limit, band * limit) << i;
    }
}

TEST_F(Tables, DiffractionIsThatOfTheVeryFrequency) {
    const SeakeepingTables& t = *s_tables;
    const StripHull hull = stripHullOf(referenceHull("s175"));
    for (const std::size_t heading : {0u, 7u, 16u, 24u}) {
        for (const std::size_t omega : {10u, 20u, 35u}) {
            const MetWave wave{t.waveOmega_radps[omega], t.headings_rad[heading], t.speeds_mps[2]};
            const double encounter = std::max(std::abs(wave.encounter_radps()), t.omega_radps.front());
            const Complex6 exact = diffractionForce(hull, flowAbout(hull, encounter), wave, true);
            const Complex6 table = t.diffraction[t.waveIndex(2, heading, omega)];
            for (const std::size_t i : {1u, 2u, 3u, 4u, 5u}) {
                const double scale = t.restoring(2, 2) * (i > 2 ? (i == 3 ? 25.4 : 175.0) : 1.0);
                EXPECT_NEAR(std::abs(exact[i] - table[i]) / scale, 0.0, 0.01)
                    << heading << ' ' << omega << ' ' << i;
            }
        }
    }
}

TEST_F(Tables, HashChangesWithWhatGoesIn) {
    HullForm form = referenceHull("s175");
    const std::uint64_t hash = tablesHash(form, {0.2, true});
    EXPECT_EQ(hash, s_tables->inputHash);
    EXPECT_NE(hash, tablesHash(form, {0.3, true}));
    EXPECT_NE(hash, tablesHash(form, {0.2, false}));
    form.mass_kg *= 1.0 + 1e-12;
    EXPECT_NE(hash, tablesHash(form, {0.2, true}));
}

TEST(Radiation, SpeedTermsAreThoseOfSalvesenTuckAndFaltinsen) {
    Radiation r;
    r.addedMass(2, 2) = 3.0;
    r.damping(2, 2) = 2.0;
    r.addedMass(2, 4) = r.addedMass(4, 2) = 0.5;
    r.damping(2, 4) = r.damping(4, 2) = 0.25;
    r.addedMass(4, 4) = 7.0;
    r.damping(4, 4) = 5.0;
    const double w = 0.8, U = 1.5;
    const AddedMassAndDamping at = radiationAt(r, w, U, false);
    EXPECT_NEAR(at.addedMass(2, 4), 0.5 - U / (w * w) * 2.0, 1e-12);
    EXPECT_NEAR(at.addedMass(4, 2), 0.5 + U / (w * w) * 2.0, 1e-12);
    EXPECT_NEAR(at.damping(2, 4), 0.25 + U * 3.0, 1e-12);
    EXPECT_NEAR(at.damping(4, 2), 0.25 - U * 3.0, 1e-12);
    EXPECT_NEAR(at.addedMass(4, 4), 7.0 + U * U / (w * w) * 3.0, 1e-12);
    EXPECT_NEAR(at.damping(4, 4), 5.0 + U * U / (w * w) * 2.0, 1e-12);
}

TEST(Radiation, AftmostSectionEndsTheIntegrals) {
    Radiation r;
    r.endAddedMass(2, 2) = 3.0;
    r.endDamping(2, 2) = 2.0;
    const AddedMassAndDamping at = radiationAt(r, 0.8, 1.5, true);
    EXPECT_NEAR(at.addedMass(2, 2), -1.5 / 0.64 * 2.0, 1e-12);
    EXPECT_NEAR(at.damping(2, 2), 1.5 * 3.0, 1e-12);
}

}  // namespace
}  // namespace sagara::core
