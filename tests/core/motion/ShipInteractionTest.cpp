#include "core/motion/ShipInteraction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

constexpr double kLength_m = 180.0, kBeam_m = 28.0, kDraught_m = 10.0;

SlenderShip ship(NorthEast at, double heading_rad, double surge_mps) {
    return {at, heading_rad, surge_mps, 0.0, kLength_m, kBeam_m, 0.7 * kLength_m * kBeam_m * kDraught_m};
}

/// Load on own, heading north, of a ship that passes on her starboard side; ahead_m from -2 L to 2 L.
std::vector<Load> passing(double own_mps, double other_mps, bool meeting, double apart_m, double depth_m) {
    std::vector<Load> loads;
    for (int i = -40; i <= 40; ++i) {
        const NorthEast at{i * kLength_m / 20.0, apart_m};
        loads.push_back(interactionLoad(ship({}, 0.0, own_mps), ship(at, meeting ? kPi : 0.0, other_mps),
                                        depth_m, 1025.0));
    }
    return loads;
}
double largest(const std::vector<Load>& loads, double Load::*member) {
    double most = 0.0;
    for (const Load& l : loads) most = std::max(most, std::abs(l.*member));
    return most;
}
int signChanges(const std::vector<Load>& loads, double Load::*member) {
    const double least = 0.05 * largest(loads, member);
    int changes = 0;
    double last = 0.0;
    for (const Load& l : loads) {
        if (std::abs(l.*member) < least) continue;
        if (last * (l.*member) < 0.0) ++changes;
        last = l.*member;
    }
    return changes;
}
constexpr double kApart_m = 70.0, kDepth_m = 15.0;
constexpr std::size_t kAbeam = 40;

TEST(ShipInteraction, MooredShipFeelsWangsForceOfAPassingShip) {
    // Wang (1975): Y = rho U^2 y/pi * double integral of S1' S2'/((x2-x1+s)^2 + y^2)^3/2 abeam, by another
    // quadrature
    const double U = 4.0, y = 90.0, S0 = 1.5 * 0.7 * kBeam_m * kDraught_m;
    const int n = 400;
    const double dx = kLength_m / n;
    double sum = 0.0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const double x1 = (i + 0.5) * dx - 0.5 * kLength_m, x2 = (j + 0.5) * dx - 0.5 * kLength_m;
            const double slopes = 64.0 * S0 * S0 * x1 * x2 / std::pow(kLength_m, 4);
            sum += slopes * dx * dx / std::pow((x2 - x1) * (x2 - x1) + y * y, 1.5);
        }
    }
    const double wang_N = 1025.0 * U * U * y / kPi * sum;
    const Load load = interactionLoad(ship({}, 0.0, 0.0), ship({0.0, y}, 0.0, U), 1e6, 1025.0);
    EXPECT_GT(load.sway_N, 0.0);
    EXPECT_NEAR(load.sway_N / wang_N, 1.0, 0.02);  // twelve strips
    EXPECT_NEAR(load.yaw_Nm, 0.0, 1e-6 * load.sway_N * kLength_m);
}

TEST(ShipInteraction, MeetingPushesTheBowAwayThenDrawsTogetherThenTurnsTheBowAway) {
    // The other comes from ahead: the sequence runs from the last of the list to the first.
    const auto loads = passing(5.0, 5.0, true, kApart_m, kDepth_m);
    EXPECT_GT(loads[kAbeam].sway_N, 0.0);  // attracted while abeam
    const auto from = [&](double lengths) { return loads[kAbeam + static_cast<std::size_t>(20 * lengths)]; };
    EXPECT_LT(from(1.0).yaw_Nm, 0.0);  // bow to port, away from a ship on the starboard bow
    EXPECT_LT(from(1.0).sway_N, 0.0);
    const double seconds = 2.0 * kLength_m / 10.0;  // (L1 + L2)/(V1 + V2)
    double felt_s = 0.0;
    for (const Load& l : loads) {
        if (std::abs(l.sway_N) > 0.1 * largest(loads, &Load::sway_N)) felt_s += kLength_m / 20.0 / 10.0;
    }
    EXPECT_GT(felt_s, 0.5 * seconds);
    EXPECT_LT(felt_s, 2.0 * seconds);
}

TEST(ShipInteraction, TheOvertakenShipIsDrawnAheadThenHeldBackAndHerMomentTurnsTwice) {
    const auto loads = passing(4.0, 6.0, false, kApart_m, kDepth_m);  // from astern: first to last
    EXPECT_GT(loads[kAbeam].sway_N, 0.0);
    std::vector<double> surge;  // of one sign after the other, each by its largest
    for (const Load& l : loads) {
        if (surge.empty() || surge.back() * l.surge_N < 0.0) surge.push_back(0.0);
        if (std::abs(l.surge_N) > std::abs(surge.back())) surge.back() = l.surge_N;
    }
    ASSERT_GE(surge.size(), 2u);
    EXPECT_GT(surge[0], 0.05 * largest(loads, &Load::surge_N));
    EXPECT_LT(surge[1], 0.0);
    EXPECT_GE(signChanges(loads, &Load::yaw_Nm), 2);
}

TEST(ShipInteraction, OvertakingLastsLongerAndGivesMoreThanMeeting) {
    const auto overtaking = passing(5.0, 6.0, false, kApart_m, kDepth_m);
    const auto meeting = passing(5.0, 6.0, true, kApart_m, kDepth_m);
    const auto impulse = [](const std::vector<Load>& loads, double closing_mps) {
        double sum = 0.0;
        for (const Load& l : loads) sum += std::abs(l.sway_N) * kLength_m / 20.0 / closing_mps;
        return sum;
    };
    EXPECT_GT(impulse(overtaking, 1.0), 2.0 * impulse(meeting, 11.0));
}

TEST(ShipInteraction, GrowsWithSpeedsFallsWithDistanceGrowsInShallowWater) {
    const auto most = [](double V1, double V2, double apart_m, double depth_m, bool meeting) {
        return largest(passing(V1, V2, meeting, apart_m, depth_m), &Load::sway_N);
    };
    EXPECT_NEAR(most(8, 8, kApart_m, kDepth_m, true) / most(4, 4, kApart_m, kDepth_m, true), 4.0, 1e-6);
    EXPECT_GT(most(8, 4, kApart_m, kDepth_m, true), most(4, 4, kApart_m, kDepth_m, true));
    EXPECT_GT(most(4, 8, kApart_m, kDepth_m, true), most(4, 4, kApart_m, kDepth_m, true));
    const double fall =
        std::log(most(5, 5, 60, kDepth_m, true) / most(5, 5, 120, kDepth_m, true)) / std::log(2.0);
    EXPECT_GT(fall, 0.8);  // "roughly like 1/distance to 1/distance^2"
    EXPECT_LT(fall, 2.2);
    EXPECT_GT(most(5, 5, kApart_m, 12.0, true), most(5, 5, kApart_m, 20.0, true));
    EXPECT_GT(most(5, 5, kApart_m, 20.0, true), most(5, 5, kApart_m, 1000.0, true));
}

TEST(ShipInteraction, IsMirroredAndEndsFarAway) {
    const Load a = interactionLoad(ship({}, 0.3, 5.0), ship({60.0, 80.0}, 0.3, 6.0), 20.0, 1025.0);
    const Load b = interactionLoad(ship({}, -0.3, 5.0), ship({60.0, -80.0}, -0.3, 6.0), 20.0, 1025.0);
    EXPECT_NEAR(a.surge_N, b.surge_N, 1e-6 * std::abs(a.sway_N));
    EXPECT_NEAR(a.sway_N, -b.sway_N, 1e-6 * std::abs(a.sway_N));
    EXPECT_NEAR(a.yaw_Nm, -b.yaw_Nm, 1e-6 * std::abs(a.yaw_Nm));
    EXPECT_EQ(
        interactionLoad(ship({}, 0.0, 5.0), ship({0.0, 4.1 * kLength_m}, 0.0, 6.0), 20.0, 1025.0).sway_N,
        0.0);
}

}  // namespace
}  // namespace sagara::core
