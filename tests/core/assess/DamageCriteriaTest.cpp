#include <gtest/gtest.h>

#include "Rubric.h"

namespace sagara::core {
namespace {

using test::Judge;
using test::terms;

Happening contact(ContactKind with, double speed_mps, double energy_J) {
    return {Happening::Kind::Contact, test::at(7.0), {1.0, 2.0}, with, speed_mps, energy_J};
}
Happening other(Happening::Kind kind) {
    return {kind, test::at(7.0), {1.0, 2.0}, ContactKind::Fender, 3.0, 1e9};
}
const Happening::Kind kOthers[] = {Happening::Kind::AnchorLetGo, Happening::Kind::Grounding,
                                   Happening::Kind::LineParted, Happening::Kind::CableParted};

TEST(ContactSpeedCriterion, IsBrokenAboveItsLimit) {
    Judge judge(terms(R"("contact-speed", "limit_mps": 0.15)"));
    judge.happens(contact(ContactKind::Fender, 0.149, 1e9));
    judge.happens(contact(ContactKind::Fender, 0.15, 1e9));
    EXPECT_TRUE(judge.deductions.empty());
    judge.happens(contact(ContactKind::Fender, 0.151, 0.0));
    ASSERT_EQ(judge.deductions.size(), 1u);
    EXPECT_EQ(judge.deductions[0].time, test::at(7.0));
    EXPECT_EQ(judge.deductions[0].place, (NorthEast{1.0, 2.0}));
    EXPECT_EQ(judge.deductions[0].value, 0.151);
    EXPECT_EQ(judge.deductions[0].limit, 0.15);
    EXPECT_EQ(judge.deductions[0].points, 4.0);
}

TEST(ContactSpeedCriterion, EachBlowCountsUpToTheWeight) {
    Judge judge(terms(R"("contact-speed", "limit_mps": 0.15)"));
    for (int i = 0; i < 4; ++i) judge.happens(contact(ContactKind::Quay, 1.0, 0.0));
    ASSERT_EQ(judge.deductions.size(), 4u);
    EXPECT_EQ(judge.deductions[2].points, 2.0);
    EXPECT_EQ(judge.deductions[3].points, 0.0);
    EXPECT_EQ(judge.memory.lost, 10.0);
}

TEST(ContactEnergyCriterion, IsBrokenAboveItsLimitHoweverSlow) {
    Judge judge(terms(R"("contact-energy", "fails": true, "limit_kJ": 60)"));
    judge.happens(contact(ContactKind::Fender, 5.0, 59'999.0));
    judge.happens(contact(ContactKind::Fender, 5.0, 60'000.0));
    EXPECT_TRUE(judge.deductions.empty());
    EXPECT_FALSE(judge.memory.broken);
    judge.happens(contact(ContactKind::Fender, 0.01, 60'001.0));
    ASSERT_EQ(judge.deductions.size(), 1u);
    EXPECT_TRUE(judge.memory.broken);
    EXPECT_EQ(judge.deductions[0].value, 60'001.0);
    EXPECT_EQ(judge.deductions[0].limit, 60'000.0);
}

class BlowOn : public ::testing::TestWithParam<ContactKind> {};

TEST_P(BlowOn, AShipIsACollisionAndOnAnythingElseADent) {
    const bool ship = GetParam() == ContactKind::Ship;
    for (const char* dent :
         {R"("contact-speed", "limit_mps": 0.15)", R"("contact-energy", "limit_kJ": 60)"}) {
        Judge judge(terms(dent));
        judge.happens(contact(GetParam(), 1.0, 1e6));
        EXPECT_EQ(judge.deductions.size(), ship ? 0u : 1u);
    }
    Judge collision(terms(R"("collision", "fails": true)"));
    collision.happens(contact(GetParam(), 1.0, 1e6));
    EXPECT_EQ(collision.deductions.size(), ship ? 1u : 0u);
    EXPECT_EQ(collision.memory.broken, ship);
}
INSTANTIATE_TEST_SUITE_P(EveryKind, BlowOn,
                         ::testing::Values(ContactKind::Fender, ContactKind::Quay, ContactKind::Breakwater,
                                           ContactKind::Shore, ContactKind::Ship));

TEST(CollisionCriterion, TheSlightestTouchCounts) {
    Judge judge(terms(R"("collision", "fails": true)"));
    judge.happens(contact(ContactKind::Ship, 0.0, 0.0));
    ASSERT_EQ(judge.deductions.size(), 1u);
    EXPECT_EQ(judge.deductions[0].limit, 0.0);
    EXPECT_TRUE(judge.memory.broken);
}

TEST(GroundingCriterion, FailsAtTheFirstTouch) {
    Judge judge(terms(R"("grounding", "fails": true)"));
    Happening h = other(Happening::Kind::Grounding);
    h.speed_mps = 0.0;
    judge.happens(h);
    ASSERT_EQ(judge.deductions.size(), 1u);
    EXPECT_TRUE(judge.memory.broken);
    EXPECT_EQ(judge.deductions[0].place, (NorthEast{1.0, 2.0}));
}

TEST(PartedCriterion, CountsLinesAndCables) {
    Judge judge(terms(R"("parted")"));
    judge.happens(other(Happening::Kind::LineParted));
    judge.happens(other(Happening::Kind::CableParted));
    ASSERT_EQ(judge.deductions.size(), 2u);
    EXPECT_EQ(judge.memory.lost, 8.0);
    EXPECT_FALSE(judge.memory.broken);  // it is not said to fail
}

TEST(DamageCriteria, MindTheirOwnHappeningsOnly) {
    struct Row {
        const char* kind;
        std::vector<Happening::Kind> minds;
    };
    using enum Happening::Kind;
    const Row rows[] = {{R"("contact-speed", "limit_mps": 0.1)", {}},
                        {R"("contact-energy", "limit_kJ": 1)", {}},
                        {R"("collision")", {}},
                        {R"("grounding")", {Grounding}},
                        {R"("parted")", {LineParted, CableParted}}};
    for (const Row& row : rows) {
        for (const Happening::Kind kind : kOthers) {
            Judge judge(terms(row.kind));
            judge.happens(other(kind));
            const bool minds = std::count(row.minds.begin(), row.minds.end(), kind) > 0;
            EXPECT_EQ(!judge.deductions.empty(), minds) << row.kind << static_cast<int>(kind);
        }
    }
}

}  // namespace
}  // namespace sagara::core
