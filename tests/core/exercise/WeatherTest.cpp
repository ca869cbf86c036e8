#include "core/exercise/Weather.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "core/exercise/Advance.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

Weather breeze() {
    Weather w;
    w.wind = {5.0, 350.0 * kDegree_rad, 0.1};
    w.swells[0] = {1.0, 12.0, 3.3, 0.8, 25.0};
    return w;
}

TEST(Weather, RampRunsInAStraightLineAndEndsExactly) {
    const WaveTable waves(1, 20.0);
    WeatherState state = startWeather(breeze(), {}, waves);
    Weather storm = breeze();
    storm.wind.speed_mps = 15.0;
    storm.wind.windFrom_rad = 10.0 * kDegree_rad;
    storm.visibility_m = 1000.0;
    changeWeather(state, storm, {}, 0, 100.0);
    for (std::int64_t tick = 0; tick <= 50 * kTicksPerSecond; ++tick) runWeather(state, waves, tick);
    EXPECT_NEAR(state.now.wind.speed_mps, 10.0, 1e-9);
    EXPECT_NEAR(wrapPi(state.now.wind.windFrom_rad), 0.0, 1e-9);  // the short way, through north
    for (std::int64_t tick = 50 * kTicksPerSecond; tick <= 100 * kTicksPerSecond; ++tick)
        runWeather(state, waves, tick);
    EXPECT_EQ(state.now.wind.speed_mps, 15.0);
    EXPECT_EQ(state.now.visibility_m, 1000.0);
}

TEST(Weather, TheSeaFollowsTheWindAsBeaufortSays) {
    const WaveTable waves(1, 20.0);
    const WeatherState state = startWeather(breeze(), {}, waves);
    ASSERT_EQ(state.sea.systems.size(), 2u);
    EXPECT_EQ(state.sea.systems[0], SeaSystem(*windSea(5.0, 350.0 * kDegree_rad, Exposure::Inshore)));
    Weather calm;
    EXPECT_TRUE(startWeather(calm, {}, waves).sea.systems.empty());  // Beaufort 0: no waves
}

TEST(Weather, ASwellThatBeginsGrowsInItsOwnShape) {
    Weather without = breeze();
    without.swells[0].significantHeight_m = 0.0;
    const Weather half = mixed(without, breeze(), 0.5);
    EXPECT_EQ(half.swells[0].significantHeight_m, 0.5);
    EXPECT_EQ(half.swells[0].peakPeriod_s, 12.0);
}

TEST(Weather, LevelsScaleItAndUnscalingGoesBack) {
    const LevelPreset hard{1.5, 2.0, 0.5};
    const Weather scaledUp = scaled(breeze(), hard);
    EXPECT_EQ(scaledUp.wind.speed_mps, 7.5);
    EXPECT_EQ(scaledUp.swells[0].significantHeight_m, 2.0);
    EXPECT_EQ(scaledUp.visibility_m, 10'000.0);
    EXPECT_NEAR(unscaled(scaledUp, hard).wind.speed_mps, 5.0, 1e-12);
}

TEST(Weather, DifficultyChangesItDuringARunInAMinute) {
    const auto world = test::lessonWorld();
    State state = startState(*world, 1);
    const double before = state.weather.now.wind.speed_mps;
    const std::vector<Command> harder{{0, 0, DifficultyOrder{5}}};
    const auto events = advance(*world, state, harder);
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events.back().kind, EventKind::LevelChanged);
    while (state.tick < 61 * kTicksPerSecond) (void)advance(*world, state);
    EXPECT_NEAR(state.weather.now.wind.speed_mps / before, 1.7 / 0.8, 1e-9);
    EXPECT_EQ(state.level, 5);
    const auto present =
        std::count_if(state.targets.begin(), state.targets.end(), [](const auto& t) { return t.present; });
    EXPECT_EQ(present, static_cast<long>(state.targets.size()));
}

TEST(Weather, WhatATrainerOrdersIsWhatComes) {
    const auto world = test::lessonWorld();
    State state = startState(*world, 5);
    WeatherOrder order;
    order.windSpeed_mps = 3.0;
    order.visibility_m = 500.0;
    order.ramp_s = 10.0;
    const std::vector<Command> commands{{0, 0, order}};
    (void)advance(*world, state, commands);
    while (state.tick < 11 * kTicksPerSecond) (void)advance(*world, state);
    EXPECT_NEAR(state.weather.now.wind.speed_mps, 3.0, 1e-9);
    EXPECT_NEAR(state.weather.now.visibility_m, 500.0, 1e-9);
}

}  // namespace
}  // namespace sagara::core
