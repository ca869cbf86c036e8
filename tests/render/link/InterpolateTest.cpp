#include "render/link/Interpolate.h"

#include <gtest/gtest.h>

#include "core/base/Angle.h"
#include "tests/render/support/Samples.h"

namespace sagara::link {
namespace {

/// A ship and a target at constant speed.
core::Snapshot under(std::int64_t tick, double heading_rad = 0.5) {
    core::Snapshot s = test::busySnapshot(tick);
    const double t_s = s.time().seconds();
    s.ships[0].motion.north_m = 6.0 * t_s;
    s.ships[0].motion.east_m = -2.5 * t_s;
    s.ships[0].motion.heading_rad = heading_rad;
    s.targets[0].position = {100.0 + 9.0 * t_s, 0.0};
    return s;
}

TEST(Interpolate, ConstantSpeedGivesConstantDisplacementPerFrameTimeAtAnyRate) {
    SnapshotTrail trail;
    for (const double rate_Hz : {23.0, 25.0, 29.97, 60.0, 144.0}) {
        std::int64_t tick = 100;
        double before_m = 0.0, targetBefore_m = 0.0;
        for (int n = 0; n < 200; ++n) {
            const core::SimTime time{2'000'000 + static_cast<std::int64_t>(1e6 * n / rate_Hz)};
            for (; core::timeOfTick(tick - 1) < time; ++tick)
                trail.add(std::make_shared<core::Snapshot>(under(tick)));
            const core::Snapshot s = trail.at(time);
            const double now_m = s.ships[0].motion.north_m, target_m = s.targets[0].position.north_m;
            if (n > 0) {
                // Frame times are whole microseconds: 6 um at this speed.
                EXPECT_NEAR(now_m - before_m, 6.0 / rate_Hz, 1.2e-5) << rate_Hz << " Hz, frame " << n;
                EXPECT_NEAR(target_m - targetBefore_m, 9.0 / rate_Hz, 2e-5);
            }
            before_m = now_m;
            targetBefore_m = target_m;
        }
    }
}

TEST(Interpolate, HeadingsTurnTheShortWay) {
    const core::Snapshot a = under(10, core::kTwoPi - 0.02), b = under(11, 0.02);
    const core::Snapshot s = interpolated(a, b, {210'000});
    EXPECT_NEAR(core::wrapPi(s.ships[0].motion.heading_rad), 0.0, 1e-12);
    core::Snapshot c = a, d = b;
    c.wind.windFrom_rad = 0.1;
    d.wind.windFrom_rad = core::kTwoPi - 0.3;
    EXPECT_NEAR(core::wrapPi(interpolated(c, d, {205'000}).wind.windFrom_rad), 0.0, 1e-12);
}

TEST(Interpolate, TheEndsAreTheSnapshotsThemselves) {
    const core::Snapshot a = under(10), b = under(11);
    EXPECT_EQ(interpolated(a, b, a.time()).ships[0].motion.north_m, a.ships[0].motion.north_m);
    EXPECT_EQ(interpolated(a, b, b.time()).ships[0].motion.north_m, b.ships[0].motion.north_m);
    EXPECT_EQ(interpolated(a, b, {900'000}).ships[0].motion.north_m, b.ships[0].motion.north_m);
}

TEST(Interpolate, AShipPutElsewhereIsNotDrawnOnTheWay) {
    const core::Snapshot a = under(10);
    core::Snapshot b = under(11);
    b.ships[0].motion.north_m += 500.0;
    EXPECT_EQ(interpolated(a, b, {210'000}).ships[0].motion.north_m, b.ships[0].motion.north_m);
}

TEST(Interpolate, TargetsAreMatchedByIndexNotByPlace) {
    core::Snapshot a = under(10), b = under(11);
    b.targets.erase(b.targets.begin());  // the first has gone
    b.targets[0].position.north_m = a.targets[1].position.north_m + 1.0;
    const core::Snapshot s = interpolated(a, b, {210'000});
    ASSERT_EQ(s.targets.size(), 1u);
    EXPECT_NEAR(s.targets[0].position.north_m, a.targets[1].position.north_m + 0.5, 1e-9);
}

TEST(Interpolate, WhatSheIsDoingIsAsTheLaterSays) {
    core::Snapshot a = under(10), b = under(11);
    b.targets[0].activity = core::Activity::NotUnderCommand;
    b.ships[0].notUnderCommand = !a.ships[0].notUnderCommand;
    const core::Snapshot s = interpolated(a, b, {210'000});
    EXPECT_EQ(s.targets[0].activity, core::Activity::NotUnderCommand);
    EXPECT_EQ(s.ships[0].notUnderCommand, b.ships[0].notUnderCommand);
}

TEST(Interpolate, LinesAndCablesRunOutEvenly) {
    core::Snapshot a = under(10), b = under(11);
    core::LineState &before = a.ships[0].lines[0], &after = b.ships[0].lines[0];
    before = {core::LineStatus::Fast, 30.0, 2000.0};
    after = {core::LineStatus::Slacking, 31.0, 1000.0};
    a.ships[0].anchors[0].cableOut_m = 50.0;
    b.ships[0].anchors[0].cableOut_m = 52.0;
    b.ships[0].anchors[0].position = a.ships[0].anchors[0].position + core::NorthEast{2.0, 0.0};
    const core::OwnShipView ship = interpolated(a, b, {210'000}).ships[0];
    EXPECT_EQ(ship.lines[0].status, core::LineStatus::Slacking);
    EXPECT_NEAR(ship.lines[0].length_m, 30.5, 1e-9);
    EXPECT_NEAR(ship.lines[0].tension_N, 1500.0, 1e-9);
    EXPECT_NEAR(ship.anchors[0].cableOut_m, 51.0, 1e-9);
    EXPECT_NEAR(ship.anchors[0].position.north_m, a.ships[0].anchors[0].position.north_m + 1.0, 1e-9);
}

TEST(Interpolate, ALineThatIsCastOffAndAnAnchorThatComesToTheGroundAreNotDrawnOnTheWay) {
    core::Snapshot a = under(10), b = under(11);
    a.ships[0].lines[0] = {core::LineStatus::Fast, 30.0, 2000.0};
    b.ships[0].lines[0] = {core::LineStatus::Parted, 0.0, 0.0};
    a.ships[0].anchors[0].onBottom = false;
    a.ships[0].anchors[0].position = {};
    const core::OwnShipView ship = interpolated(a, b, {210'000}).ships[0];
    EXPECT_EQ(ship.lines[0].status, core::LineStatus::Parted);
    EXPECT_EQ(ship.lines[0].length_m, 0.0);
    EXPECT_EQ(ship.anchors[0].position, b.ships[0].anchors[0].position);
}

TEST(Interpolate, TheSeaIsNeverMixed) {
    core::Snapshot a = under(10), b = under(11);
    b.sea.systems[0].significantHeight_m = 2.0;
    EXPECT_EQ(interpolated(a, b, {210'000}).sea.systems, b.sea.systems);
}

TEST(Interpolate, ARunSetBackBeginsTheTrailAnew) {
    SnapshotTrail trail;
    trail.add(std::make_shared<core::Snapshot>(under(1000)));
    trail.add(std::make_shared<core::Snapshot>(under(10)));
    EXPECT_EQ(trail.newest(), core::timeOfTick(10));
    EXPECT_EQ(trail.at(core::timeOfTick(1000)).tick, 10);
}

}  // namespace
}  // namespace sagara::link
