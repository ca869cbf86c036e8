#include "core/exercise/TargetOrders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/Angle.h"
#include "core/base/Random.h"
#include "core/exercise/Advance.h"
#include "core/exercise/BuildId.h"
#include "core/exercise/Recording.h"
#include "core/exercise/Replay.h"
#include "core/exercise/Session.h"
#include "core/exercise/Snapshot.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::core {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

AddTargetOrder ferry(NorthEast at, double heading_deg, double speed_kn) {
    AddTargetOrder order;
    order.name = "Ferry";
    order.type = TargetType::Ferry;
    order.position = at;
    order.heading_rad = heading_deg * kDegree_rad;
    order.speed_mps = speed_kn * kKnot_mps;
    order.length_m = 60.0;
    order.beam_m = 12.0;
    order.draught_m = 3.0;
    return order;
}

/// Two targets that go round, two own ships, no mission.
class AddedTargets : public ::testing::Test {
protected:
    const std::shared_ptr<const World> world = test::worldOf(test::openWaterScenario(1, 2));
    State state = startState(*world, 3);
    std::vector<Event> events;

    void give(Order order) {
        const std::vector<Command> commands{{state.tick, 0, std::move(order)}};
        for (Event& e : advance(*world, state, commands)) events.push_back(std::move(e));
    }
    void run(double seconds) {
        const auto end = state.tick + std::llround(seconds * kTicksPerSecond);
        while (state.tick < end) (void)advance(*world, state);
    }
    TargetState& third() { return state.targets.at(2); }
};

TEST_F(AddedTargets, AShipIsThereAtOnceAndKeepsHerCourse) {
    state.weather.now.current = state.weather.base.current = {};
    give(ferry({-4000.0, -3000.0}, 90.0, 12.0));
    ASSERT_EQ(state.targets.size(), 3u);
    EXPECT_EQ(events.back().kind, EventKind::TargetAppeared);
    EXPECT_EQ(events.back().index, 2);
    const Snapshot seen = view(*world, state);
    EXPECT_EQ(seen.targets.back().index, 2u);
    EXPECT_EQ(targetLayout(*world, seen, 2).name, "Ferry");
    EXPECT_EQ(targetLayout(*world, seen, 2).id, "added-1");
    EXPECT_EQ(targetLayout(*world, seen, 1).id, "target-1");
    const NorthEast from = third().position;
    run(100.0);
    EXPECT_NEAR(third().position.east_m - from.east_m, 100.0 * 12.0 * kKnot_mps, 2.0);
    EXPECT_NEAR(third().position.north_m, from.north_m, 2.0);
    EXPECT_NEAR(third().heading_rad, kPi / 2, 1e-6);
}

TEST_F(AddedTargets, WithARouteSheFollowsItAndStopsAtItsEnd) {
    state.weather.now.current = state.weather.base.current = {};
    AddTargetOrder order = ferry({-4000.0, -3000.0}, 0.0, 12.0);
    order.route = {{{-3000.0, -3000.0}, 6.0}, {{-3000.0, -2000.0}, 6.0}};
    give(order);
    run(800.0);
    EXPECT_LT(distance(third().position, {-3000.0, -2000.0}), 80.0);
    EXPECT_LT(third().speed_mps, 0.7);
}

TEST_F(AddedTargets, WithNoSpeedSheLiesAtAnchorAndOrderedOffSheIsUnderWay) {
    give(ferry({-4000.0, -3000.0}, 200.0, 0.0));
    EXPECT_EQ(activityNow(state.added[0], third()), Activity::Anchored);
    run(20.0);
    EXPECT_EQ(third().position, (NorthEast{-4000.0, -3000.0}));
    give(SteerTargetOrder{2, kPi, 5.0});
    EXPECT_EQ(activityNow(state.added[0], third()), Activity::UnderWay);
    run(120.0);
    EXPECT_NEAR(third().speed_mps, 5.0, 0.3);
    EXPECT_NEAR(std::abs(wrapPi(third().heading_rad)), kPi, 0.02);
}

TEST_F(AddedTargets, AHostileOneLiesOnTheHeadingGivenAndComesWhenTheOwnShipIsNear) {
    AddTargetOrder order = ferry(state.ships[0].motion.position() + NorthEast{1500.0, 0.0}, 45.0, 30.0);
    order.type = TargetType::FastCraft;
    order.length_m = 9.0;
    order.beam_m = 3.0;
    order.draught_m = 0.8;
    order.hostile = true;
    give(order);
    EXPECT_NEAR(third().heading_rad, kPi / 4, 0.02);
    run(60.0);
    EXPECT_NE(third().phase, HostilePhase::Loiter);
}

TEST_F(AddedTargets, OneOfTheScenarioIsSteeredRoutedMovedAndGoesOnByHerself) {
    give(SteerTargetOrder{0, 0.0, 3.0});
    run(200.0);
    EXPECT_NEAR(wrapPi(state.targets[0].heading_rad), 0.0, 0.02);
    EXPECT_NEAR(state.targets[0].speed_mps, 3.0, 0.1);

    const NorthEast goal = state.targets[0].position + NorthEast{0.0, 600.0};
    give(RouteTargetOrder{0, {{goal, 5.0}}});
    run(300.0);
    EXPECT_LT(distance(state.targets[0].position, goal), 80.0);

    give(MoveTargetOrder{0, {-8000.0, 1000.0}, 1.0});
    EXPECT_LT(distance(state.targets[0].position, {-8000.0, 1000.0}), 2.0);
    EXPECT_EQ(events.back().kind, EventKind::TargetMoved);

    give(TargetOrder{0, TargetAction::Resume, 0.0});
    EXPECT_FALSE(state.targets[0].underOrders());
    run(60.0);
    EXPECT_NEAR(state.targets[0].speed_mps, 9.0 * kKnot_mps, 1.5);  // as her route says
}

TEST_F(AddedTargets, GoesAndComesBackWhereSheBeganAndWithNoLevel) {
    give(ferry({-4000.0, -3000.0}, 90.0, 12.0));
    give(DifficultyOrder{1});
    EXPECT_TRUE(third().present);
    run(50.0);
    give(TargetOrder{2, TargetAction::Remove, 0.0});
    EXPECT_EQ(view(*world, state).targets.size(), 2u);
    give(TargetOrder{2, TargetAction::Appear, 0.0});
    EXPECT_LT(distance(third().position, {-4000.0, -3000.0}), 1.0);
}

TEST_F(AddedTargets, AreAtMost32) {
    for (int i = 0; i < 40; ++i) give(ferry({-4000.0, -3000.0 - 300.0 * i}, 90.0, 12.0));
    EXPECT_EQ(state.added.size(), kMostAddedTargets);
    EXPECT_EQ(state.targets.size(), 2u + kMostAddedTargets);
    EXPECT_EQ(state.added.back().id, "added-32");
}

TEST_F(AddedTargets, OrdersOutOfRangeDoNothing) {
    State same = state;
    const auto with = [](auto change) {
        AddTargetOrder order = ferry({}, 0.0, 10.0);
        change(order);
        return Order(order);
    };
    const std::vector<Order> nonsense{
        with([](auto& o) { o.position.north_m = kNan; }),
        with([](auto& o) { o.position.east_m = 1e9; }),
        with([](auto& o) { o.heading_rad = kInfinity; }),
        with([](auto& o) { o.speed_mps = -1.0; }),
        with([](auto& o) { o.speed_mps = 99.0; }),
        with([](auto& o) { o.length_m = 0.0; }),
        with([](auto& o) { o.length_m = kNan; }),
        with([](auto& o) { o.beam_m = 1e6; }),
        with([](auto& o) { o.draught_m = -2.0; }),
        with([](auto& o) { o.name = std::string(61, 'x'); }),
        with([](auto& o) { o.type = static_cast<TargetType>(200); }),
        with([](auto& o) { o.activity = static_cast<Activity>(77); }),
        with([](auto& o) {
            o.route.assign(65, {{1.0, 1.0}, 3.0});
        }),
        with([](auto& o) {
            o.route = {{{kNan, 0.0}, 3.0}};
        }),
        MoveTargetOrder{0, {kNan, 0.0}, 0.0},
        MoveTargetOrder{0, {0.0, 0.0}, kInfinity},
        MoveTargetOrder{99, {0.0, 0.0}, 0.0},
        SteerTargetOrder{0, kNan, 1.0},
        SteerTargetOrder{0, 0.0, kNan},
        SteerTargetOrder{0, 0.0, 1000.0},
        SteerTargetOrder{99, 0.0, 1.0},
        RouteTargetOrder{0, {}},
        RouteTargetOrder{0, {{{0.0, kInfinity}, 1.0}}},
        RouteTargetOrder{99, {{{0.0, 0.0}, 1.0}}},
        TargetOrder{0, TargetAction::SetSpeed, kInfinity},
        TargetOrder{0, TargetAction::SetSpeed, kNan},
    };
    for (const Order& order : nonsense) give(order);
    for (std::size_t i = 0; i < nonsense.size(); ++i) (void)advance(*world, same);
    EXPECT_EQ(stateHash(state), stateHash(same));
    EXPECT_TRUE(events.empty());
}

TEST_F(AddedTargets, AnyOrderFromRandomBytesLeavesAllFinite) {
    Random random(7);
    int tried = 0;
    for (int i = 0; i < 20'000; ++i) {
        Bytes bytes(1 + random.next() % 200);
        for (std::byte& b : bytes) b = static_cast<std::byte>(random.next());
        bytes[0] = static_cast<std::byte>(random.next() % std::variant_size_v<Order>);
        ArchiveReader reader(bytes);
        Order order;
        reader(order);
        if (!reader.ok() || std::holds_alternative<FinishOrder>(order)) continue;
        // what the weather does with wild numbers is another matter
        if (std::holds_alternative<WeatherOrder>(order) || std::holds_alternative<HelmOrder>(order) ||
            std::holds_alternative<ShaftOrder>(order) || std::holds_alternative<AutopilotOrder>(order) ||
            std::holds_alternative<AnchorOrder>(order))
            continue;
        give(order);
        ++tried;
    }
    EXPECT_GT(tried, 1000);
    EXPECT_FALSE(state.stopped);
    for (const TargetState& t : state.targets)
        EXPECT_TRUE(std::isfinite(t.position.north_m + t.position.east_m + t.heading_rad + t.speed_mps));
}

TEST_F(AddedTargets, AreRecordedAndReplayedToTheBitAndKeptInTheTrack) {
    Bytes bytes;
    RecordingWriter writer([&](std::span<const std::byte> piece) { append(bytes, piece); });
    RecordingHeader header;
    header.buildId = coreBuildId();
    header.documents = world->documents;
    header.level = 3;
    Session session(world, startState(*world, 3), {}, &writer);
    writer.begin(header, *world, session.state());
    while (session.state().tick < 30 * kTicksPerSecond) {
        if (session.state().tick == 222) session.give(0, ferry({-4000.0, -3000.0}, 90.0, 12.0));
        if (session.state().tick == 900) session.give(0, SteerTargetOrder{2, 1.0, 3.0});
        if (session.state().tick == 1000) session.give(0, ferry({-5000.0, -3000.0}, 10.0, 4.0));
        (void)session.step();
    }
    writer.end(session.state());

    const auto recording = readRecording(bytes);
    ASSERT_TRUE(recording) << recording.error();
    EXPECT_EQ(recording->damage, "");
    ASSERT_EQ(recording->added.size(), 2u);
    EXPECT_EQ(recording->added[0], session.state().added[0]);
    const auto last = replay(*world, *recording, recording->endTick, [](const auto&, auto, auto) {});
    ASSERT_TRUE(last) << last.error();
    EXPECT_EQ(stateHash(*last), stateHash(session.state()));

    const auto track = recording->track(1, 2);
    ASSERT_EQ(track.size(), 151u);
    for (const TrackSample& sample : track) {
        ASSERT_EQ(sample.targets.size(), 4u);
        EXPECT_EQ(sample.targets[2].present, sample.tick > 222);
        EXPECT_EQ(sample.targets[3].present, sample.tick > 1000);
    }
    EXPECT_NEAR(track.back().targets[2].position.north_m, last->targets[2].position.north_m, 0.051);
    EXPECT_NEAR(track.back().targets[3].heading_rad, last->targets[3].heading_rad, 0.001);
    EXPECT_TRUE(track.back().targets[0].present);
}

}  // namespace
}  // namespace sagara::core
