#include "core/world/Activity.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "core/world/Target.h"

namespace sagara::core {
namespace {

TEST(Activity, EachHasANameOfItsOwn) {
    std::set<std::string> names;
    for (int i = 0; i <= static_cast<int>(kLastActivity); ++i)
        names.insert(activityName(static_cast<Activity>(i)));
    EXPECT_EQ(names.size(), static_cast<std::size_t>(kLastActivity) + 1);
    EXPECT_EQ(names.count(""), 0u);
}

TEST(Activity, WhoLiesIsAtAnchorAndAYachtSailsUnlessTheScenarioSaysOtherwise) {
    using enum TargetBehaviour;
    EXPECT_EQ(usualActivity(TargetType::Fishing, Lying), Activity::Anchored);
    EXPECT_EQ(usualActivity(TargetType::Yacht, Lying), Activity::Anchored);
    EXPECT_EQ(usualActivity(TargetType::Yacht, Route), Activity::Sailing);
    EXPECT_EQ(usualActivity(TargetType::Fishing, Circuit), Activity::UnderWay);
    EXPECT_EQ(usualActivity(TargetType::FastCraft, Hostile), Activity::UnderWay);
}

TEST(Activity, AStoppedTargetIsNotUnderCommandUnlessSheLayBefore) {
    TargetLayout layout;
    TargetState state;
    for (const Activity activity : {Activity::UnderWay, Activity::Fishing, Activity::Towing}) {
        layout.activity = activity;
        state.stopped = false;
        EXPECT_EQ(activityNow(layout, state), activity);
        state.stopped = true;
        EXPECT_EQ(activityNow(layout, state), Activity::NotUnderCommand);
    }
    for (const Activity lying : {Activity::Anchored, Activity::Moored}) {
        layout.activity = lying;
        EXPECT_EQ(activityNow(layout, state), lying);
    }
}

}  // namespace
}  // namespace sagara::core
