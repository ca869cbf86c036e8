#include <gtest/gtest.h>

#include "Rubric.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

constexpr NorthEast kMark{2000.0, 900.0};
constexpr double kWind_rad = 45.0 * kDegree_rad;

/// A ship that lies to her port anchor as she should, 0.3 kn, 60 s, 120 s, 30 deg.
class BroughtUp : public ::testing::Test {
protected:
    std::unique_ptr<const Task> task =
        test::Rubric().task(R"({"id": "anchor", "title": "Anchor", "kind": "anchor", "at": "mark",
        "within_m": 75, "shackles": [4, 5], "speed_kn": 0.3, "still_s": 60, "hold_s": 120, "weather_deg": 30})");
    Observation now;
    TaskMemory memory;

    void SetUp() override {
        now.anchors[0] = {true, kMark, 4.5 * kShackle_m, 0.0, 0.0};
        now.position = kMark - NorthEast{80.0, 80.0};
        now.heading_rad = now.windFrom_rad = kWind_rad;
        now.time = test::at(1000.0);
    }
    bool look() { return task->step(now, memory); }
    /// Five looks a second; whether it was done in that time.
    template <typename Each>
    bool lie(double for_s, Each&& each) {
        bool done = false;
        for (std::int64_t i = 0; i < std::llround(5.0 * for_s); ++i) {
            each();
            done = look() || done;
            now.time.us += 200'000;
        }
        return done;
    }
    bool lie(double for_s) {
        return lie(for_s, [] {});
    }
};

TEST_F(BroughtUp, AfterTwoMinutesOfHolding) {
    EXPECT_FALSE(lie(120.0));
    EXPECT_TRUE(look());  // 120 s after the first look
}

TEST_F(BroughtUp, NotWithoutAnAnchorDown) {
    now.anchors[0].down = false;
    EXPECT_FALSE(lie(600.0));
}

TEST_F(BroughtUp, TheWatchBeginsWhenTheAnchorIsDown) {
    now.anchors[0].down = false;
    lie(300.0);
    now.anchors[0].down = true;
    EXPECT_FALSE(lie(120.0));
    EXPECT_TRUE(look());
}

TEST_F(BroughtUp, AndAnewWhenItHasBeenUp) {
    lie(100.0);
    now.anchors[0].down = false;
    look();
    now.anchors[0].down = true;
    EXPECT_FALSE(lie(119.0));
}

TEST_F(BroughtUp, AnAnchorThatDragsStartsTheTwoMinutesAgain) {
    lie(100.0);
    now.anchors[0].dragSpeed_mps = 0.1;
    lie(25.0);
    now.anchors[0].dragSpeed_mps = 0.0;
    EXPECT_FALSE(lie(119.0));  // last seen moving 0.2 s before
    EXPECT_TRUE(lie(2.0));
}

TEST_F(BroughtUp, AJerkOfTheSeaCostsSeconds) {
    lie(100.0);
    now.anchors[0].dragSpeed_mps = 0.1;
    lie(1.0);  // 0.1 m: 5 s
    now.anchors[0].dragSpeed_mps = 0.0;
    EXPECT_FALSE(lie(23.0));
    EXPECT_TRUE(lie(2.0));
}

TEST_F(BroughtUp, NotWhileSheMakesGoodMoreThanTheSpeed) {
    const auto drift = [this](double speed_kn) {
        return [this, speed_kn] { now.position.north_m += speed_kn * kKnot_mps * 0.2; };
    };
    EXPECT_FALSE(lie(600.0, drift(0.31)));
    EXPECT_TRUE(lie(130.0, drift(0.29)));
}

TEST_F(BroughtUp, StillForAMinuteAfterSheHasMovedOn) {
    lie(130.0, [this] {
        now.position.north_m += 0.5 * kKnot_mps * 0.2;
        now.momentarySpeed_mps = 0.5 * kKnot_mps;
    });
    now.momentarySpeed_mps = 0.0;
    EXPECT_FALSE(lie(20.0));
    EXPECT_TRUE(lie(60.0));
}

TEST_F(BroughtUp, ToAndFroInTheSwellDoesNotMatter) {
    double time_s = 0.0;
    EXPECT_TRUE(lie(135.0, [&] {  // surged by 0.5 kn in 12 s waves
        time_s += 0.2;
        const double phase = kTwoPi * time_s / 12.0, most_mps = 0.5 * kKnot_mps;
        now.position.north_m = kMark.north_m - most_mps * 12.0 / kTwoPi * std::cos(phase);
        now.momentarySpeed_mps = most_mps * std::abs(std::sin(phase));
    }));
}

TEST_F(BroughtUp, NotAtAMomentWhenSheIsFast) {
    now.momentarySpeed_mps = 0.301 * kKnot_mps;
    EXPECT_FALSE(lie(300.0));
    now.momentarySpeed_mps = 0.299 * kKnot_mps;
    EXPECT_TRUE(lie(1.2));
}

TEST_F(BroughtUp, IsTickedOffAtAWholeSecond) {
    now.time = test::at(1000.4);
    EXPECT_FALSE(lie(120.4));  // up to 1120.6
    EXPECT_TRUE(lie(0.6));     // 1121.0 is among these
}

struct Heading {
    double offWind_deg;
    bool good;
};
class BroughtUpHeading : public BroughtUp, public ::testing::WithParamInterface<Heading> {};
TEST_P(BroughtUpHeading, IsWithinThirtyDegreesOfTheWind) {
    now.heading_rad = kWind_rad + GetParam().offWind_deg * kDegree_rad;
    EXPECT_EQ(lie(130.0), GetParam().good);
}
INSTANTIATE_TEST_SUITE_P(OffTheWind, BroughtUpHeading,
                         ::testing::Values(Heading{29.9, true}, Heading{30.1, false}, Heading{-29.9, true},
                                           Heading{-30.1, false}, Heading{180.0, false},
                                           Heading{-335.0, true}, Heading{390.1, false}));

struct Shackles {
    double out;
    bool good;
};
class BroughtUpCable : public BroughtUp, public ::testing::WithParamInterface<Shackles> {};
TEST_P(BroughtUpCable, IsFourToFiveShacklesAsReadOffTheMarks) {
    now.anchors[0].cableOut_m = GetParam().out * kShackle_m;
    EXPECT_EQ(lie(130.0), GetParam().good);
}
INSTANTIATE_TEST_SUITE_P(Out, BroughtUpCable,
                         ::testing::Values(Shackles{3.94, false}, Shackles{3.96, true}, Shackles{4.0, true},
                                           Shackles{5.0, true}, Shackles{5.04, true}, Shackles{5.06, false}));

TEST_F(BroughtUp, TheAnchorLiesNearTheMarkWhereverTheShipIs) {
    now.anchors[0].position = kMark + NorthEast{75.1, 0.0};
    EXPECT_FALSE(lie(130.0));
    now.anchors[0].position = kMark + NorthEast{74.9, 0.0};
    EXPECT_TRUE(lie(1.2));
}

TEST_F(BroughtUp, OnTheOtherAnchorAsWell) {
    now.anchors[1] = now.anchors[0];
    now.anchors[0] = {};
    EXPECT_TRUE(lie(121.0));
}

TEST_F(BroughtUp, IsTheSameWheneverItBegins) {
    for (std::int64_t begin_s = 1; begin_s < 3600; ++begin_s) {
        memory = {};
        now.time = SimTime::fromSeconds(begin_s);
        ASSERT_FALSE(look());
        now.time = SimTime::fromSeconds(begin_s + 119);
        ASSERT_FALSE(look());
        now.time = SimTime::fromSeconds(begin_s + 120);
        ASSERT_TRUE(look()) << begin_s;
    }
}

}  // namespace
}  // namespace sagara::core
