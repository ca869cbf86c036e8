#include "ui/sound/FogSignal.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sagara::ui {
namespace {

using core::Activity;

/// Blasts of the horn in two minutes and how long they sound together.
std::pair<int, double> blasts(Activity activity, bool makingWay, double length_m = 50.0) {
    int count = 0;
    double sounding_s = 0.0;
    bool before = fogSignal(activity, makingWay, length_m, -0.05).horn;
    for (int i = 0; i < 1200; ++i) {
        const bool on = fogSignal(activity, makingWay, length_m, 0.1 * i + 0.05).horn;
        if (on && !before) ++count;
        if (on) sounding_s += 0.1;
        before = on;
    }
    return {count, sounding_s};
}

TEST(FogSignal, Rule35IsKept) {
    EXPECT_EQ(blasts(Activity::UnderWay, true).first, 1);
    EXPECT_NEAR(blasts(Activity::UnderWay, true).second, 5.0, 0.2);
    EXPECT_EQ(blasts(Activity::UnderWay, false).first, 2);
    EXPECT_NEAR(blasts(Activity::UnderWay, false).second, 10.0, 0.2);
    for (const Activity a : {Activity::NotUnderCommand, Activity::Restricted, Activity::Sailing,
                             Activity::Fishing, Activity::Trawling, Activity::Towing}) {
        EXPECT_EQ(blasts(a, true).first, 3);
        EXPECT_NEAR(blasts(a, true).second, 7.0, 0.2);  // one prolonged, two short
    }
    EXPECT_EQ(blasts(Activity::Moored, false).first, 0);
}

TEST(FogSignal, AtAnchorTheBellRingsAndTheGongFromAHundredMetres) {
    EXPECT_EQ(fogSignal(Activity::Anchored, false, 50.0, 2.0), (FogSignal{false, true, false}));
    EXPECT_EQ(fogSignal(Activity::Anchored, false, 50.0, 7.0), FogSignal{});
    EXPECT_EQ(fogSignal(Activity::Anchored, false, 150.0, 7.0), (FogSignal{false, false, true}));
    EXPECT_EQ(fogSignal(Activity::Anchored, false, 150.0, 62.0), (FogSignal{false, true, false}));
    EXPECT_EQ(blasts(Activity::Anchored, false).first, 0);
}

TEST(FogSignal, TimeBeforeTheStartIsTimeToo) {
    EXPECT_EQ(fogSignal(Activity::UnderWay, true, 50.0, -118.0).horn, true);
    EXPECT_EQ(fogSignal(Activity::UnderWay, true, 50.0, -100.0).horn, false);
}

}  // namespace
}  // namespace sagara::ui
