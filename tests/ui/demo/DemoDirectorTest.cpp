#include "ui/demo/DemoDirector.h"

#include <gtest/gtest.h>

namespace sagara::ui {
namespace {

using Act = DemoDirector::Act;
using Phase = DemoDirector::Phase;

constexpr double kBeat_s = 0.5;

/// Lets time pass in beats; the first thing to be done, and when.
std::optional<Act> pass(DemoDirector& director, double seconds, bool over = false, bool spoilt = false) {
    for (double t = 0.0; t < seconds; t += kBeat_s)
        if (const auto act = director.advance(kBeat_s, over, spoilt)) return act;
    return std::nullopt;
}

TEST(DemoDirector, ChangesTheCameraEveryTwelveSecondsWhileThePilotSails) {
    DemoDirector director({});
    EXPECT_EQ(pass(director, 11.5), std::nullopt);
    EXPECT_EQ(pass(director, 0.5), Act::NextCamera);
    EXPECT_EQ(pass(director, 11.5), std::nullopt);
    EXPECT_EQ(pass(director, 0.5), Act::NextCamera);
    EXPECT_EQ(director.phase(), Phase::Attract);
}

TEST(DemoDirector, TheEndOfTheLessonResets) {
    DemoDirector director({});
    EXPECT_EQ(director.advance(kBeat_s, true), Act::Reset);
    EXPECT_EQ(director.phase(), Phase::Attract);
}

TEST(DemoDirector, ATouchTakesTheHelmForThreeMinutesThenTheScoreThenAReset) {
    DemoDirector director({});
    EXPECT_EQ(director.touched(), Act::TakeHelm);
    EXPECT_EQ(director.phase(), Phase::Helm);
    for (int i = 0; i < 7; ++i) {  // touched every 25 s: nobody has gone
        EXPECT_EQ(pass(director, 25.0), std::nullopt);
        EXPECT_EQ(director.touched(), std::nullopt);
    }
    EXPECT_NEAR(director.helmLeft_s(), 5.0, 1e-9);
    EXPECT_EQ(pass(director, 5.0), Act::ShowScore);
    EXPECT_EQ(director.phase(), Phase::Score);
    EXPECT_EQ(pass(director, 19.5), std::nullopt);
    EXPECT_EQ(pass(director, 0.5), Act::Reset);
    EXPECT_EQ(director.phase(), Phase::Attract);
}

TEST(DemoDirector, AMinuteWithoutATouchResetsWithoutAScore) {
    DemoDirector director({});
    director.touched();
    EXPECT_EQ(pass(director, 59.5), std::nullopt);
    EXPECT_NEAR(director.idleLeft_s(), 0.5, 1e-9);
    EXPECT_EQ(pass(director, 0.5), Act::Reset);
}

TEST(DemoDirector, AShipAgroundEndsTheTurnAfterAWhile) {
    DemoDirector director({});
    director.touched();
    EXPECT_EQ(pass(director, 4.5, false, true), std::nullopt);
    EXPECT_EQ(pass(director, 0.5, false, true), Act::ShowScore);
}

TEST(DemoDirector, TheEndOfTheLessonAtTheHelmShowsTheScore) {
    DemoDirector director({});
    director.touched();
    EXPECT_EQ(director.advance(kBeat_s, true), Act::ShowScore);
    EXPECT_EQ(director.advance(kBeat_s, true), std::nullopt);
}

TEST(DemoDirector, ATouchTakesTheScoreAwayButNotAtOnce) {
    DemoDirector director({});
    director.touched();
    director.advance(kBeat_s, true);
    EXPECT_EQ(director.touched(), std::nullopt);
    EXPECT_EQ(pass(director, 2.0), std::nullopt);
    EXPECT_EQ(director.touched(), Act::Reset);
    EXPECT_EQ(director.touched(), Act::TakeHelm);
}

TEST(DemoDirector, TimesAreParameters) {
    DemoTiming fast;
    fast.camera_s = 1.0;
    fast.idle_s = 2.0;
    DemoDirector director(fast);
    EXPECT_EQ(pass(director, 1.0), Act::NextCamera);
    director.touched();
    EXPECT_EQ(pass(director, 2.0), Act::Reset);
}

}  // namespace
}  // namespace sagara::ui
