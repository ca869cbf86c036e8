#include "core/exercise/Prediction.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "core/exercise/Advance.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

TEST(Prediction, InACalmIsExactlyWhatComes) {
    const auto world = test::worldOf(test::with(
        test::openWaterScenario(1, 3), "/weather",
        R"({"wind": {"speed_kn": 0, "from_deg": 0, "gustiness": 0}, "exposure": "inshore", "visibility_M": 10})"));
    State state = startState(*world, 3);
    const std::vector<Command> helm{{0, 0, HelmOrder{10 * kDegree_rad}}};
    (void)advance(*world, state, helm);
    const auto poses = predict(*world, state, 0, 60.0, 10.0);
    ASSERT_EQ(poses.size(), 7u);
    for (const PredictedPose& pose : poses) {
        while (state.time() < pose.time) (void)advance(*world, state);
        EXPECT_EQ(state.ships[0].motion.position(), pose.position);
        EXPECT_EQ(state.ships[0].motion.heading_rad, pose.heading_rad);
    }
}

TEST(Prediction, LeavesTheStateAloneAndEndsAtTheGround) {
    const auto world =
        test::worldOf(test::with(test::openWaterScenario(1, 0), "/ownShips/0/heading_deg", "20"));
    const State state = startState(*world, 3);  // north from 5.995 N: into the rocks of Rumassala or the fort
    const auto before = stateHash(state);
    const auto poses = predict(*world, state, 0, 1800.0, 10.0);
    EXPECT_EQ(stateHash(state), before);
    EXPECT_LT(poses.back().time.seconds(), 1790.0);
}

}  // namespace
}  // namespace sagara::core
