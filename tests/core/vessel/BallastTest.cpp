#include "core/vessel/Ballast.h"

#include <gtest/gtest.h>

#include "tests/support/Assets.h"

namespace sagara::core {
namespace {

Vessel shipped(const std::string& id) {
    return loadVessel(id, test::readAsset("vessels/" + id + ".json")).value();
}

TEST(Ballast, OfKvlcc2FloatsHigherLighterAndStiffer) {
    const Vessel loaded = shipped("kvlcc2");
    const auto ballast = inBallast(loaded);
    ASSERT_TRUE(ballast);
    // MARPOL asks for 8.4 m; a ship of 20.8 m is not brought above 0.55 of it.
    EXPECT_NEAR(ballast->hull.draught_m, 11.44, 1e-9);
    // Tankers in ballast displace 45 to 55 % of the load.
    const double share = ballast->hull.displacement_m3 / loaded.hull.displacement_m3;
    EXPECT_GT(share, 0.45);
    EXPECT_LT(share, 0.55);
    EXPECT_GT(ballast->hull.metacentricHeight_m, loaded.hull.metacentricHeight_m);
    EXPECT_EQ(ballast->hull.provenance.quality, Quality::Estimated);
    const auto& before = std::get<MmgModel>(loaded.models.front().parameters).parameters;
    const auto& after = std::get<MmgModel>(ballast->models.front().parameters).parameters;
    EXPECT_LT(after.hull.Yv, 0.0);
    EXPECT_LT(after.inertia.my, before.inertia.my);
    // Less water moves with her, and less of her is wetted.
    EXPECT_LT(after.hull.R0 * ballast->hull.draught_m, before.hull.R0 * loaded.hull.draught_m);
}

TEST(Ballast, OfAVesselWithTwoMmgModelsHasBoth) {
    const auto ballast = inBallast(shipped("rib8"));
    ASSERT_TRUE(ballast);
    ASSERT_EQ(ballast->models.size(), 2u);
    ASSERT_TRUE(ballast->models[0].holds);
    EXPECT_TRUE(ballast->model(ballast->models[0].holds->elsewhere));
}

TEST(Ballast, NeedsAnMmgModel) {
    Vessel patrol = shipped("patrol51");
    std::erase_if(patrol.models,
                  [](const NamedModel& m) { return std::holds_alternative<MmgModel>(m.parameters); });
    EXPECT_FALSE(inBallast(patrol));
}

}  // namespace
}  // namespace sagara::core
