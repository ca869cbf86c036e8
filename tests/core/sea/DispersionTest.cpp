#include "core/sea/Dispersion.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

constexpr double kTableGravity_mps2 = 9.81;  // the reference file says so

TEST(Dispersion, AgreesWithTheReferenceTable) {
    for (const test::Row& row : test::readReference("waves/dispersion_check.csv")) {
        const double depth_m = row.has("depth") ? row["depth"] : kDeep_m;
        const double k = waveNumber_radpm(kTwoPi / row["T"], depth_m, kTableGravity_mps2);
        EXPECT_NEAR(k / row["k"], 1.0, 1e-6) << row["T"] << " s, " << depth_m << " m";
        EXPECT_NEAR(groupSpeed_mps(k, depth_m, kTableGravity_mps2) / row["group_speed"], 1.0, 1e-6);
        EXPECT_NEAR(angularFrequency_radps(k, depth_m, kTableGravity_mps2) / row["w"], 1.0, 1e-9);
    }
}

TEST(Dispersion, EncounterFrequencyAgreesWithTheReferenceTable) {
    for (const test::Row& row : test::readReference("waves/encounter_check.csv")) {
        const double k = waveNumber_radpm(row["w"], kDeep_m, kTableGravity_mps2);
        EXPECT_NEAR(encounterFrequency_radps(row["w"], k, row["U"], row["heading_deg"] * kDegree_rad),
                    row["we"],
                    2e-9);  // the table has ten digits of w and of we
    }
}

}  // namespace
}  // namespace sagara::core
