#include "ui/demo/DemoHelm.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::ui {
namespace {

constexpr double kDeg = core::kDegree_rad;

class Helm : public ::testing::Test {
protected:
    void SetUp() override {
        m_world = test::worldOf(test::openWaterScenario(1, 0));
        m_now = core::view(*m_world, core::startState(*m_world, 3));
    }
    DemoHelm::Orders take() { return m_helm.take(*m_world->ships[0], m_now.ships[0]); }

    std::shared_ptr<const core::World> m_world;
    core::Snapshot m_now;
    DemoHelm m_helm;
};

TEST_F(Helm, TakingItEndsPilotAndAutopilotAndKeepsHerGoing) {
    const auto orders = take();
    ASSERT_EQ(orders.size(), 4u);
    EXPECT_FALSE(std::get<core::PilotOrder>(orders[0]).engage);
    EXPECT_EQ(std::get<core::AutopilotOrder>(orders[1]).mode, core::AutopilotMode::Off);
    EXPECT_EQ(std::get<core::HelmOrder>(orders[2]).rudder_rad, 0.0);
    EXPECT_GE(std::get<core::TelegraphOrder>(orders[3]).step, core::TelegraphStep::SlowAhead);
}

TEST_F(Helm, EveryPressIsFiveDegreesUpToTheLimit) {
    take();
    const auto orders = m_helm.press(DemoHelm::Key::Port);
    ASSERT_EQ(orders.size(), 1u);
    EXPECT_NEAR(std::get<core::HelmOrder>(orders[0]).rudder_rad, -5.0 * kDeg, 1e-12);
    for (int i = 0; i < 20; ++i) m_helm.press(DemoHelm::Key::Starboard);
    EXPECT_NEAR(m_helm.rudder_rad(), m_world->ships[0]->vessel.steering.limit_rad, 1e-12);
    m_helm.press(DemoHelm::Key::Midships);
    EXPECT_EQ(m_helm.rudder_rad(), 0.0);
}

TEST_F(Helm, TheEngineGoesStepByStepAndEndsAtFull) {
    take();
    for (int i = 0; i < 12; ++i) m_helm.press(DemoHelm::Key::Faster);
    EXPECT_EQ(m_helm.step(), core::TelegraphStep::FullAhead);
    const auto orders = m_helm.press(DemoHelm::Key::Slower);
    EXPECT_EQ(std::get<core::TelegraphOrder>(orders.at(0)).step, core::TelegraphStep::HalfAhead);
    EXPECT_EQ(std::get<core::TelegraphOrder>(orders.at(0)).shaft, core::kAllShafts);
    for (int i = 0; i < 12; ++i) m_helm.press(DemoHelm::Key::Slower);
    EXPECT_EQ(m_helm.step(), core::TelegraphStep::FullAstern);
}

TEST_F(Helm, TheStickSteersOnlyOnceItIsMoved) {
    take();
    EXPECT_TRUE(m_helm.move({0.3, 0.0, false}).empty()) << "where it stood when she was taken";
    EXPECT_TRUE(m_helm.move({0.33, 0.02, false}).empty()) << "a worn stick trembles";
    const auto orders = m_helm.move({-1.0, 1.0, false});
    ASSERT_EQ(orders.size(), 2u);
    EXPECT_NEAR(m_helm.rudder_rad(), -m_world->ships[0]->vessel.steering.limit_rad, 1e-12);
    EXPECT_EQ(m_helm.step(), core::TelegraphStep::FullAhead);
}

TEST(DemoStick, ATremblingStickIsNoTouch) {
    EXPECT_FALSE(stickMoved({0.0, 0.0, false}, {0.05, -0.05, false}));
    EXPECT_TRUE(stickMoved({0.0, 0.0, false}, {0.2, 0.0, false}));
    EXPECT_TRUE(stickMoved({0.0, 0.0, false}, {0.0, 0.0, true}));
    EXPECT_FALSE(stickMoved({0.0, 0.0, true}, {0.0, 0.0, true})) << "a button held down is one touch";
}

}  // namespace
}  // namespace sagara::ui
