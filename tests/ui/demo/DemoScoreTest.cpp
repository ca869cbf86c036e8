#include "ui/demo/DemoScore.h"

#include <gtest/gtest.h>

#include "core/base/Units.h"

namespace sagara::ui {
namespace {

using Verdict = DemoScore::Verdict;

/// So long at that speed and that far off a track with a corridor of 100 m and a limit of 10 kn.
void sail(DemoScore& score, double seconds, double speed_kn, double off_m) {
    core::Snapshot now;
    now.ships.resize(1);
    now.ships[0].overGround_mps = {speed_kn * core::kKnot_mps, 0.0};
    Hints hints;
    hints.track = Hints::OffTrack{off_m, 100.0};
    hints.speedLimit_mps = 10.0 * core::kKnot_mps;
    score.add(seconds, now, hints);
}

TEST(DemoScore, AQuietPassageOnTheRouteHasFiveStars) {
    DemoScore score;
    sail(score, 180.0, 8.0, 20.0);
    EXPECT_EQ(score.stars(), 5);
    EXPECT_EQ(score.verdict(), Verdict::Perfect);
    EXPECT_NEAR(score.sailed_m(), 180.0 * 8.0 * core::kKnot_mps, 1e-9);
}

TEST(DemoScore, OutsideTheCorridorCostsStars) {
    DemoScore half;
    sail(half, 130.0, 8.0, 20.0);
    sail(half, 50.0, 8.0, -150.0);
    EXPECT_EQ(half.stars(), 4);
    EXPECT_EQ(half.verdict(), Verdict::Good);
    DemoScore out;
    sail(out, 180.0, 8.0, 400.0);
    EXPECT_EQ(out.stars(), 3);
    EXPECT_EQ(out.verdict(), Verdict::LeftTheChannel);
}

TEST(DemoScore, LyingStillAndRacingAreTold) {
    DemoScore still;
    sail(still, 180.0, 0.5, 0.0);
    EXPECT_EQ(still.verdict(), Verdict::Drifted);
    DemoScore fast;
    sail(fast, 180.0, 14.0, 0.0);
    EXPECT_EQ(fast.verdict(), Verdict::TooFast);
    EXPECT_EQ(fast.stars(), 4);
}

TEST(DemoScore, AGroundingIsTheFirstThingSaid) {
    DemoScore score;
    sail(score, 180.0, 8.0, 400.0);
    core::Event event;
    event.kind = core::EventKind::Grounding;
    score.happened(event);
    EXPECT_TRUE(score.spoilt());
    EXPECT_EQ(score.verdict(), Verdict::RanAground);
    EXPECT_EQ(score.stars(), 2);
}

TEST(DemoScore, AFenderTouchedGentlyIsNoHarm) {
    DemoScore score;
    core::Event event;
    event.kind = core::EventKind::Contact;
    event.contact = core::ContactKind::Fender;
    event.value = 0.1;
    score.happened(event);
    EXPECT_FALSE(score.spoilt());
    event.value = 1.5;
    score.happened(event);
    EXPECT_TRUE(score.spoilt());
    EXPECT_EQ(score.verdict(), Verdict::Touched);
}

TEST(DemoScore, WhoOnlyTookALookHasOneStar) {
    DemoScore score;
    sail(score, 5.0, 8.0, 0.0);
    EXPECT_EQ(score.stars(), 1);
    EXPECT_EQ(score.verdict(), Verdict::TookALook);
}

}  // namespace
}  // namespace sagara::ui
