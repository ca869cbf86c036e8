#include "render/scene/Moment.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"

namespace sagara::render {
namespace {

core::Snapshot snapshotAt(std::int64_t tick, double north_m, double heading_rad) {
    core::Snapshot s;
    s.tick = tick;
    s.ships.resize(1);
    s.ships[0].motion.north_m = north_m;
    s.ships[0].motion.heading_rad = heading_rad;
    core::TargetView target;
    target.index = 3;
    target.position = {0.0, north_m};
    s.targets.push_back(target);
    return s;
}

TEST(Moment, HasWhatTheSnapshotShows) {
    const Moment m = momentOf(snapshotAt(50, 7.5, 90.0 * core::kDegree_rad));
    EXPECT_EQ(m.time.seconds(), 1.0);
    ASSERT_EQ(m.ships.size(), 1u);
    EXPECT_EQ(m.ships[0].position.north_m, 7.5);
    EXPECT_EQ(m.ships[0].heading_rad, 90.0 * core::kDegree_rad);
    EXPECT_EQ(m.ships[0].activity, core::Activity::UnderWay);
    ASSERT_EQ(m.targets.size(), 1u);
    EXPECT_EQ(m.targets[0].index, 3u);
    EXPECT_EQ(m.targets[0].position.east_m, 7.5);
}

TEST(Moment, AnAnchorOnTheGroundAndALineOnABollardChangeHerLights) {
    core::Snapshot s = snapshotAt(0, 0.0, 0.0);
    core::AnchorState anchor;
    anchor.onBottom = true;
    anchor.cableOut_m = 50.0;
    s.ships[0].anchors.push_back(anchor);
    EXPECT_EQ(momentOf(s).ships[0].activity, core::Activity::Anchored);
    EXPECT_EQ(momentOf(s).ships[0].anchors.at(0).cableOut_m, 50.0);
    s.ships[0].lines.resize(1);
    s.ships[0].lines[0].status = core::LineStatus::Fast;
    s.ships[0].lines[0].length_m = 12.0;
    EXPECT_EQ(momentOf(s).ships[0].activity, core::Activity::Moored);
    EXPECT_EQ(momentOf(s).ships[0].lines.at(0).length_m, 12.0);
}

TEST(Moment, SaysWhatTargetsAreDoingAndWhetherTheyMakeWay) {
    core::Snapshot s = snapshotAt(0, 0.0, 0.0);
    s.targets[0].activity = core::Activity::Trawling;
    s.targets[0].speed_mps = 0.1;
    EXPECT_EQ(momentOf(s).targets[0].activity, core::Activity::Trawling);
    EXPECT_FALSE(momentOf(s).targets[0].makingWay());
    s.targets[0].speed_mps = 1.5;
    EXPECT_TRUE(momentOf(s).targets[0].makingWay());
}

}  // namespace
}  // namespace sagara::render
