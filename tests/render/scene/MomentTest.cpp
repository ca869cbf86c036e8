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

TEST(Moment, ConstantSpeedGivesConstantDisplacementAtAnyFrameRate) {
    for (const std::int64_t frame_us : {6'944, 16'667, 33'333, 40'000}) {
        double last_m = 0.0;
        for (std::int64_t n = 0; n < 200; ++n) {
            const core::SimTime time{n * frame_us};
            const std::int64_t tick = time.us / core::kTick_us;
            const auto place = [](std::int64_t t) { return 7.5 * core::timeOfTick(t).seconds(); };
            const Moment m =
                between(snapshotAt(tick, place(tick), 0.0), snapshotAt(tick + 1, place(tick + 1), 0.0), time);
            const double step_m = 7.5 * static_cast<double>(frame_us) * 1e-6;
            EXPECT_NEAR(m.ships[0].position.north_m - last_m, n > 0 ? step_m : 0.0, 1e-9);
            EXPECT_NEAR(m.targets[0].position.east_m, m.ships[0].position.north_m, 1e-9);
            last_m = m.ships[0].position.north_m;
        }
    }
}

TEST(Moment, HeadingTurnsTheShortWay) {
    const Moment m = between(snapshotAt(0, 0.0, 359.0 * core::kDegree_rad),
                             snapshotAt(1, 0.0, 1.0 * core::kDegree_rad), core::SimTime{10'000});
    EXPECT_NEAR(m.ships[0].heading_rad / core::kDegree_rad, 360.0, 1e-9);
}

TEST(Moment, ATargetThatGoesStaysWhereItWas) {
    core::Snapshot later = snapshotAt(1, 1.0, 0.0);
    later.targets.clear();
    const Moment m = between(snapshotAt(0, 0.0, 0.0), later, core::SimTime{10'000});
    ASSERT_EQ(m.targets.size(), 1u);
    EXPECT_EQ(m.targets[0].position.east_m, 0.0);
}

}  // namespace
}  // namespace sagara::render
