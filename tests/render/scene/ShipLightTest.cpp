#include "render/scene/light/ShipLights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "core/base/Units.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::render {
namespace {

using core::Activity;
using core::kDegree_rad;

char letterOf(const ShipLight& light) {
    const auto& c = light.colour;
    return c[1] < 0.5 ? 'R' : c[0] < 0.5 ? 'G' : c[2] < 0.5 ? 'Y' : 'W';
}

/// Colours seen from a bearing, one letter a light, sorted.
std::string seen(const std::vector<ShipLight>& lights, double bearing_deg) {
    std::string letters;
    for (const ShipLight& light : lights)
        if (light.seenFrom(bearing_deg * kDegree_rad) > 0.99) letters += letterOf(light);
    std::sort(letters.begin(), letters.end());
    return letters;
}

ShipForm ship(core::TargetType type, double length_m) {
    core::TargetLayout t;
    t.type = type;
    t.length_m = length_m;
    t.beam_m = length_m / 6.0;
    t.draught_m = length_m / 18.0;
    return formOf(t);
}

/// What is seen 40 degrees on either bow and from right astern.
struct Row {
    const char* rule;
    core::TargetType type;
    double length_m;
    Activity activity;
    bool makingWay;
    const char *port, *starboard, *astern;
};
constexpr auto kFishing = core::TargetType::Fishing;
constexpr auto kCoaster = core::TargetType::Coaster;
constexpr auto kTug = core::TargetType::Tug;
constexpr auto kYacht = core::TargetType::Yacht;
constexpr auto kFast = core::TargetType::FastCraft;
const Row kRows[] = {
    {"23a two mastheads from 50 m", kCoaster, 50, Activity::UnderWay, true, "RWW", "GWW", "W"},
    {"23a one under 50 m", kCoaster, 49, Activity::UnderWay, true, "RW", "GW", "W"},
    {"23a stopped but under way", kCoaster, 78, Activity::UnderWay, false, "RWW", "GWW", "W"},
    {"23a a yacht under power", kYacht, 14, Activity::UnderWay, true, "RW", "GW", "W"},
    {"23d all round white under 12 m", kFishing, 11, Activity::UnderWay, true, "RW", "GW", "W"},
    {"23d white alone under 7 m", kFishing, 6, Activity::UnderWay, true, "W", "W", "W"},
    {"23d but not who is fast", kFast, 6, Activity::UnderWay, true, "RW", "GW", "W"},
    {"24a towing", kTug, 30, Activity::Towing, true, "RWW", "GWW", "WY"},
    {"24d towing from 50 m", kTug, 60, Activity::Towing, true, "RWWW", "GWWW", "WY"},
    {"25a sailing", kYacht, 14, Activity::Sailing, true, "R", "G", "W"},
    {"26b trawling making way", kFishing, 20, Activity::Trawling, true, "GRW", "GGW", "GWW"},
    {"26b trawling stopped", kFishing, 20, Activity::Trawling, false, "GW", "GW", "GW"},
    {"26b trawling from 50 m", kFishing, 60, Activity::Trawling, true, "GRWW", "GGWW", "GWW"},
    {"26c fishing making way", kFishing, 12, Activity::Fishing, true, "RRW", "GRW", "RWW"},
    {"26c fishing stopped", kFishing, 12, Activity::Fishing, false, "RW", "RW", "RW"},
    {"26c fishing from 50 m", kFishing, 60, Activity::Fishing, false, "RW", "RW", "RW"},
    {"27a not under command making way", kCoaster, 78, Activity::NotUnderCommand, true, "RRR", "GRR", "RRW"},
    {"27a not under command stopped", kCoaster, 78, Activity::NotUnderCommand, false, "RR", "RR", "RR"},
    {"27b restricted making way", kTug, 30, Activity::Restricted, true, "RRRWW", "GRRWW", "RRWW"},
    {"27b restricted from 50 m", kTug, 60, Activity::Restricted, true, "RRRWWW", "GRRWWW", "RRWW"},
    {"27b restricted stopped", kTug, 30, Activity::Restricted, false, "RRW", "RRW", "RRW"},
    {"27g not required under 12 m", kFishing, 11, Activity::NotUnderCommand, true, "RW", "GW", "W"},
    {"27g nor restricted", kFishing, 11, Activity::Restricted, true, "RW", "GW", "W"},
    {"30a two from 50 m", kCoaster, 78, Activity::Anchored, false, "WW", "WW", "WW"},
    {"30b one under 50 m", kCoaster, 49, Activity::Anchored, false, "W", "W", "W"},
    {"30c decks lit from 100 m", kCoaster, 100, Activity::Anchored, false, "WWWWWWW", "WWWWWWW", "WWWWWWW"},
    {"30e none under 7 m", kFishing, 6, Activity::Anchored, false, "", "", ""},
    {"moored", kCoaster, 78, Activity::Moored, false, "", "", ""},
};

class LightsByRule : public ::testing::TestWithParam<Row> {
protected:
    const Row row = GetParam();
    const ShipForm form = ship(row.type, row.length_m);
    const std::vector<ShipLight> lights = lightsOf(form, row.activity, row.makingWay);
};
INSTANTIATE_TEST_SUITE_P(Colreg, LightsByRule, ::testing::ValuesIn(kRows), [](const auto& row) {
    std::string name = row.param.rule;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

TEST_P(LightsByRule, AreSeenFromEitherBowAndAstern) {
    EXPECT_EQ(seen(lights, -40.0), row.port) << row.rule;
    EXPECT_EQ(seen(lights, 40.0), row.starboard) << row.rule;
    EXPECT_EQ(seen(lights, 180.0), row.astern) << row.rule;
}

TEST_P(LightsByRule, HaveTheArcsAndRangesOfRules21And22) {
    for (const ShipLight& light : lights) {
        const double arc_deg = (light.to_rad - light.from_rad) / kDegree_rad;
        const bool allRound = arc_deg > 359.0,
                   masthead = arc_deg > 224.0 && arc_deg<226.0, side = arc_deg> 112.0 &&
                              arc_deg<113.0, stern = arc_deg> 134.0 && arc_deg < 136.0;
        EXPECT_TRUE(allRound || masthead || side || stern) << arc_deg;
        if (light.range_M < 1.0) continue;  // on deck
        const double L = row.length_m;
        const double range_M = masthead           ? (L >= 50   ? 6.0
                                                     : L >= 20 ? 5.0
                                                               : 3.0)
                               : L >= 50          ? 3.0
                               : side && L < 12.0 ? 1.0
                                                  : 2.0;
        EXPECT_EQ(light.range_M, range_M) << row.rule << ", " << letterOf(light) << " of " << arc_deg;
    }
}

TEST_P(LightsByRule, HangAboveEachOtherByAnnexI) {
    const double least_m = row.length_m >= 20.0 ? 2.0 : 1.0;  // section 2(i)
    for (const ShipLight& a : lights) {
        for (const ShipLight& b : lights) {
            const bool sameMast = a.position.x == b.position.x && a.position.y == 0.0 && b.position.y == 0.0;
            if (&a == &b || !sameMast) continue;
            EXPECT_GE(std::abs(a.position.up - b.position.up), least_m - 1e-9) << row.rule;
        }
        EXPECT_GT(a.position.up, form.freeboard_m) << row.rule;
    }
}

TEST(ShipLights, ColoursAreInTheirOrderFromTheTop) {
    const auto fromTop = [](Activity activity) {
        auto lights = lightsOf(ship(kFishing, 24.0), activity, false);
        std::sort(lights.begin(), lights.end(),
                  [](const ShipLight& a, const ShipLight& b) { return a.position.up > b.position.up; });
        std::string letters;
        for (const ShipLight& light : lights) letters += letterOf(light);
        return letters;
    };
    EXPECT_EQ(fromTop(Activity::Trawling), "GW");
    EXPECT_EQ(fromTop(Activity::Fishing), "RW");
    EXPECT_EQ(fromTop(Activity::NotUnderCommand), "RR");
    EXPECT_EQ(fromTop(Activity::Restricted), "RWR");
    const auto astern = lightsOf(ship(kTug, 30.0), Activity::Towing);
    EXPECT_EQ(letterOf(astern.back()), 'Y');  // above the sternlight
    EXPECT_GT(astern.back().position.up, astern[astern.size() - 2].position.up + 1.9);
}

TEST(ShipLights, AMastheadLightIsAboveTheOthersOfWhoIsPowerDriven) {
    for (const double length_m : {8.0, 13.0, 30.0, 78.0, 190.0}) {
        const auto lights = lightsOf(ship(kCoaster, length_m), Activity::UnderWay);
        for (const ShipLight& light : lights)
            EXPECT_TRUE(&light == &lights[0] || (length_m >= 50.0 && &light == &lights[1]) ||
                        light.position.up < lights[0].position.up)
                << length_m;
    }
    // Annex I, 2(k): the forward anchor light 4.5 m above the after one.
    const auto anchor = lightsOf(ship(kCoaster, 60.0), Activity::Anchored);
    EXPECT_GE(anchor[0].position.up, anchor[1].position.up + 4.5 - 1e-9);
}

TEST(ShipLights, TheLessonsShipIsLongEnoughForTwoMastheadLights) {
    const ShipForm form = formOf(test::lessonWorld()->ships[0]->vessel);
    const auto lights = lightsOf(form, Activity::UnderWay);
    EXPECT_EQ(seen(lights, 40.0), "GWW");
    EXPECT_EQ(seen(lights, -40.0), "RWW");
    EXPECT_EQ(seen(lights, 180.0), "W");  // sternlight
    EXPECT_EQ(seen(lights, 118.0), "W");
    EXPECT_EQ(seen(lights, 107.0), "GWW");
    EXPECT_EQ(seen(lightsOf(form, Activity::Anchored), 77.0), "WW");
    EXPECT_GT(lights[1].position.up, lights[0].position.up + 4.4);
    EXPECT_LT(lights[1].position.x, lights[0].position.x);
}

TEST(ShipLights, StandWhereThePictureHasThem) {
    ShipForm form = formOf(test::lessonWorld()->ships[0]->vessel);
    const auto place = [&](core::LightPlace at) -> auto& {
        return form.lights[static_cast<std::size_t>(at)];
    };
    place(core::LightPlace::MastheadForward) = Point{20.0, 0.0, 9.0};
    place(core::LightPlace::MastheadAft) = Point{-5.0, 0.0, 15.0};
    place(core::LightPlace::Port) = Point{3.0, -4.0, 6.0};
    place(core::LightPlace::AnchorForward) = Point{24.0, 0.0, 8.0};
    const auto lights = lightsOf(form, Activity::UnderWay);
    EXPECT_EQ(seen(lights, -40.0), "RWW");
    EXPECT_EQ(lights[0].position.up, 9.0);
    EXPECT_EQ(lights[1].position.x, -5.0);
    EXPECT_EQ(lights[2].position.y, -4.0);
    EXPECT_EQ(lights[3].position.y, 0.5 * form.beam_m);  // not placed: where it usually is
    EXPECT_EQ(lightsOf(form, Activity::Anchored)[0].position.x, 24.0);
}

}  // namespace
}  // namespace sagara::render
