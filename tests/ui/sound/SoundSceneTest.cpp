#include "ui/sound/SoundScene.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"
#include "tests/support/exercise/Lesson.h"
#include "ui/sound/FogSignal.h"

namespace sagara::ui {
namespace {

class Scenes : public testing::Test {
protected:
    std::shared_ptr<const core::World> world = test::worldOf(test::openWaterScenario(1, 8));
    core::Snapshot now = core::view(*world, core::startState(*world, 5));
    SoundScene scene(const BridgeSounds& bridge = {}) const { return soundSceneOf(*world, now, bridge); }
};

TEST_F(Scenes, MoreRevolutionsAreMoreEngine) {
    auto& shafts = now.ships[0].shafts_rps;
    const double full_rps = world->ships[0]->vessel.propulsion.telegraph_rps.back();
    ASSERT_FALSE(shafts.empty());
    std::fill(shafts.begin(), shafts.end(), 0.4 * full_rps);
    const SoundScene half = scene();
    std::fill(shafts.begin(), shafts.end(), full_rps);
    const SoundScene full = scene();
    EXPECT_EQ(half.engines.size(), shafts.size());
    EXPECT_GT(full.engines[0].firing_Hz, half.engines[0].firing_Hz);
    EXPECT_GT(full.engines[0].load, half.engines[0].load);
    EXPECT_GT(full.wash, half.wash);
    EXPECT_NEAR(full.blades_Hz, 4.0 * full_rps, 1e-9);
    std::fill(shafts.begin(), shafts.end(), -full_rps);
    EXPECT_EQ(scene().engines[0].firing_Hz, full.engines[0].firing_Hz);  // astern sounds alike
    EXPECT_LT(scene().engines[0].shaft_rpm, 0.0);
}

TEST_F(Scenes, BowWaveGrowsWithSpeedAndIsStillWhenStopped) {
    core::ShipMotion& m = now.ships[0].motion;
    m.surge_mps = m.sway_mps = 0.0;
    EXPECT_EQ(scene().bowWave, 0.0);
    double before = 0.0;
    for (double speed_mps = 1.0; speed_mps < 12.0; speed_mps += 1.0) {
        m.surge_mps = speed_mps;
        const double bow = scene().bowWave;
        EXPECT_GE(bow, before);
        EXPECT_LE(bow, 1.0);
        before = bow;
    }
    EXPECT_GT(before, 0.8);
}

TEST_F(Scenes, WindIsThatOverTheDeck) {
    core::OwnShipView& ship = now.ships[0];
    ship.motion.heading_rad = 0.0;
    ship.overGround_mps = {10.0, 0.0};
    now.wind = {10.0, core::kPi};  // from astern, as fast as she
    EXPECT_NEAR(scene().windSpeed_mps, 0.0, 1e-9);
    now.wind = {10.0, 0.0};
    EXPECT_NEAR(scene().windSpeed_mps, 20.0, 1e-9);
    EXPECT_NEAR(scene().windFrom_rad, 0.0, 1e-9);
}

TEST_F(Scenes, CableRunsLouderThanItIsHoveIn) {
    ASSERT_FALSE(now.ships[0].anchors.empty());
    EXPECT_EQ(scene().cableLinks_Hz, 0.0);
    now.ships[0].anchors[0].status = core::AnchorStatus::Heaving;
    const double heaving_Hz = scene().cableLinks_Hz;
    EXPECT_GT(heaving_Hz, 0.0);
    now.ships[0].anchors[0].status = core::AnchorStatus::Running;
    EXPECT_GT(scene().cableLinks_Hz, 5.0 * heaving_Hz);
}

TEST_F(Scenes, ShipsSoundOnlyInRestrictedVisibilityAndSoundTakesItsTime) {
    ASSERT_FALSE(now.targets.empty());
    now.weather.visibility_m = 10'000.0;
    EXPECT_TRUE(scene().others.empty());
    now.weather.visibility_m = 500.0;
    const core::NorthEast own = now.ships[0].motion.position();
    now.targets.resize(1);
    core::TargetView& target = now.targets[0];
    target.activity = core::Activity::UnderWay;
    target.speed_mps = 5.0;
    ASSERT_GE(world->targets[target.index].length_m, 12.0);
    // When the blast begins to be heard, near by and a mile away: 4.8 s apart at 340 m/s and 1652 m.
    const auto begins_s = [&](double away_m) {
        target.position = own + core::NorthEast{0.0, away_m};
        bool before = true;
        for (int tick = 0; tick < 7000; ++tick) {
            now.tick = tick;
            const bool on = scene().others.at(0).horn;
            if (on && !before) return now.time().seconds();
            before = on;
        }
        return -1.0;
    };
    EXPECT_NEAR(begins_s(1852.0) - begins_s(200.0), 1652.0 / 340.0, 0.03);
    target.position = own + core::NorthEast{0.0, 9000.0};
    EXPECT_TRUE(scene().others.empty());
}

TEST_F(Scenes, WhatTheBridgeDoesIsHeard) {
    const SoundScene s = scene({true, true, true, 0.3, true});
    EXPECT_TRUE(s.horn && s.bell && s.alarm && s.listener.outside);
    EXPECT_EQ(s.listener.look_rad, 0.3);
    EXPECT_GT(s.listener.at.up_m, 0.0);
}

TEST_F(Scenes, AShipThatIsNotThereHearsNothing) {
    const SoundScene s = soundSceneOf(*world, now, {true, true, true, 0.0, false}, 7);
    EXPECT_TRUE(s.engines.empty());
    EXPECT_FALSE(s.horn);
}

}  // namespace
}  // namespace sagara::ui
