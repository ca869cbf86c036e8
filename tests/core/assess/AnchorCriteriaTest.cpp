#include <gtest/gtest.h>

#include "Rubric.h"
#include "core/base/Units.h"

namespace sagara::core {
namespace {

using test::Judge;
using test::terms;

constexpr NorthEast kMark{2000.0, 900.0};

Happening letGo(NorthEast anchor, double ahead_mps) {
    return {Happening::Kind::AnchorLetGo, test::at(1200.0), anchor, ContactKind::Fender, ahead_mps, 0.0};
}

TEST(AnchorPlaceCriterion, IsBrokenWhenTheAnchorIsLetGoTooFarFromTheMark) {
    Judge judge(terms(R"("anchor-place", "at": "mark", "limit_m": 50)"));
    judge.happens(letGo(kMark + NorthEast{0.0, 49.9}, 0.0));
    judge.happens(letGo(kMark - NorthEast{50.0, 0.0}, 0.0));
    EXPECT_TRUE(judge.deductions.empty());
    judge.happens(letGo(kMark + NorthEast{30.0, 40.1}, 0.0));
    ASSERT_EQ(judge.deductions.size(), 1u);
    EXPECT_NEAR(judge.deductions[0].value, std::hypot(30.0, 40.1), 1e-9);
    EXPECT_EQ(judge.deductions[0].limit, 50.0);
    EXPECT_EQ(judge.deductions[0].place, (kMark + NorthEast{30.0, 40.1}));
    EXPECT_EQ(judge.deductions[0].time, test::at(1200.0));
}

TEST(AnchorPlaceCriterion, MindsTheAnchorNotTheShip) {
    Judge judge(terms(R"("anchor-place", "at": "mark", "limit_m": 50)"));
    judge.now.position = kMark + NorthEast{500.0, 0.0};  // she has veered and fallen back
    judge.now.anchors[0] = {true, kMark, 100.0, 0.0, 0.0};
    judge.look(1300.0);
    judge.close();
    EXPECT_TRUE(judge.deductions.empty());
}

TEST(AnchorPlaceCriterion, MindsNothingButAnAnchorLetGo) {
    Judge judge(terms(R"("anchor-place", "at": "mark", "limit_m": 50)"));
    for (const auto kind : {Happening::Kind::Contact, Happening::Kind::Grounding, Happening::Kind::LineParted,
                            Happening::Kind::CableParted}) {
        Happening far = letGo({}, 0.0);
        far.kind = kind;
        judge.happens(far);
    }
    EXPECT_TRUE(judge.deductions.empty());
}

struct Sternway {
    const char* name;
    double ahead_kn;
    bool broken;
    double limit_kn;
};
const Sternway kSternways[] = {
    {"JustTooSlow", -0.29, true, 0.3},    {"SlowestAllowed", -0.3, false, 0.0}, {"Between", -0.5, false, 0.0},
    {"FastestAllowed", -0.8, false, 0.0}, {"JustTooFast", -0.81, true, 0.8},    {"Stopped", 0.0, true, 0.3},
    {"Headway", 0.5, true, 0.3},
};
class LetGoSpeed : public ::testing::TestWithParam<Sternway> {};

TEST_P(LetGoSpeed, IsSternwayBetweenItsLimits) {
    Judge judge(terms(R"("let-go-speed", "least_kn": 0.3, "most_kn": 0.8)"));
    judge.happens(letGo(kMark, GetParam().ahead_kn * kKnot_mps));
    ASSERT_EQ(judge.deductions.size(), GetParam().broken ? 1u : 0u);
    if (!GetParam().broken) return;
    EXPECT_DOUBLE_EQ(judge.deductions[0].value, -GetParam().ahead_kn * kKnot_mps);
    EXPECT_DOUBLE_EQ(judge.deductions[0].limit, GetParam().limit_kn * kKnot_mps);
    EXPECT_EQ(judge.deductions[0].points, 4.0);
}
INSTANTIATE_TEST_SUITE_P(Astern, LetGoSpeed, ::testing::ValuesIn(kSternways),
                         [](const auto& row) { return row.param.name; });

TEST(LetGoSpeedCriterion, RefusesLimitsThatNobodyCanMeet) {
    EXPECT_EQ(test::Rubric().problemsOfCriterion(terms(R"("let-go-speed", "least_kn": 0.8, "most_kn": 0.3)")),
              "rubric: most_kn is less than least_kn, expected at least as much");
}

class AnchorDrag : public ::testing::Test {
protected:
    Judge judge{terms(R"("anchor-drag", "limit_m": 10)")};
    double time_s = 100.0;

    void look(std::size_t anchor, bool down, double dragged_m) {
        judge.now.anchors[anchor].down = down;
        judge.now.anchors[anchor].dragged_m = dragged_m;
        judge.look(time_s += 0.2);
    }
};

TEST_F(AnchorDrag, IsBrokenBeyondItsLimit) {
    look(0, true, 9.9);
    look(0, true, 10.0);
    EXPECT_TRUE(judge.deductions.empty());
    judge.now.position = {5.0, 6.0};
    look(0, true, 10.1);
    ASSERT_EQ(judge.deductions.size(), 1u);
    EXPECT_EQ(judge.deductions[0].value, 10.1);
    EXPECT_EQ(judge.deductions[0].limit, 10.0);
    EXPECT_EQ(judge.deductions[0].place, (NorthEast{5.0, 6.0}));
    EXPECT_EQ(judge.deductions[0].time, test::at(time_s));
}

TEST_F(AnchorDrag, CostsOnceHoweverFarItGoes) {
    for (double dragged_m = 0.0; dragged_m < 200.0; dragged_m += 1.0) look(0, true, dragged_m);
    EXPECT_EQ(judge.deductions.size(), 1u);
}

TEST_F(AnchorDrag, ANewAttemptIsGradedAnew) {
    look(0, true, 11.0);
    look(0, false, 11.0);
    look(0, true, 0.0);
    look(0, true, 9.0);
    EXPECT_EQ(judge.deductions.size(), 1u);
    look(0, true, 12.0);
    EXPECT_EQ(judge.deductions.size(), 2u);
}

TEST_F(AnchorDrag, AnAnchorThatIsUpDoesNotDrag) {
    look(0, false, 50.0);
    EXPECT_TRUE(judge.deductions.empty());
}

TEST_F(AnchorDrag, AnyAnchorCounts) {
    look(0, true, 0.0);
    look(1, true, 11.0);
    EXPECT_EQ(judge.deductions.size(), 1u);
}

}  // namespace
}  // namespace sagara::core
