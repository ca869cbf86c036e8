#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/Units.h"
#include "render/scene/light/LightCharacter.h"
#include "render/scene/light/ShipLights.h"
#include "render/scene/light/Visibility.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::render {
namespace {

using core::kDegree_rad;

/// Times of lighting within the first `span_s` seconds, a hundredth of a second each.
std::vector<double> flashes(const LightCharacter& light, double span_s) {
    std::vector<double> starts;
    bool before = false;
    for (std::int64_t us = 0; us < static_cast<std::int64_t>(span_s * 1e6); us += 10'000) {
        const bool now = light.lit(core::SimTime{us});
        if (now && !before) starts.push_back(static_cast<double>(us) * 1e-6);
        before = now;
    }
    return starts;
}

TEST(LightCharacter, GalleLightFlashesTwiceEvery15Seconds) {
    const auto light = LightCharacter::parse("Fl(2) W 15s");
    ASSERT_TRUE(light);
    EXPECT_EQ(flashes(*light, 30.0), (std::vector<double>{0.0, 2.0, 15.0, 17.0}));
}

TEST(LightCharacter, IsInPhaseWithSimulationTimeAlways) {
    const auto light = LightCharacter::parse("Fl(2) W 15s");
    for (const std::int64_t period : {1, 1000, 5760}) {
        EXPECT_TRUE(light->lit(core::SimTime{period * 15'000'000}));
        EXPECT_FALSE(light->lit(core::SimTime{period * 15'000'000 - 1}));
    }
}

TEST(LightCharacter, ReadsTheCharactersOfTheLightList) {
    struct Row {
        const char* text;
        std::size_t flashesAMinute;
    };
    for (const Row& row : {Row{"Q W", 60}, Row{"VQ W", 120}, Row{"Q(9) W 15s", 36}, Row{"Q(6)+LFl W 15s", 28},
                           Row{"Iso W 4s", 15}, Row{"LFl W 10s", 6}, Row{"Oc R 6s", 10}, Row{"Fl G 3s", 20},
                           Row{"Mo(A) W 8s", 15}}) {
        const auto light = LightCharacter::parse(row.text);
        ASSERT_TRUE(light) << row.text;
        EXPECT_NEAR(static_cast<double>(flashes(*light, 240.0).size()) / 4.0,
                    static_cast<double>(row.flashesAMinute), 0.5)
            << row.text;
    }
    EXPECT_EQ(flashes(*LightCharacter::parse("F R"), 60.0).size(), 1u);
}

TEST(LightCharacter, RefusesWhatItDoesNotKnow) {
    for (const char* text : {"", "Fl", "Fl(2 W 15s", "Fl(0) W 15s", "Fl(9) W 5s", "Fl W -3s", "Fl X 3s",
                             "Blink W 3s", "Fl W 3s extra", "Iso W"})
        EXPECT_FALSE(LightCharacter::parse(text)) << text;
}

TEST(LightCharacter, EveryLightOfGalleIsUnderstood) {
    const auto world = test::lessonWorld();  // outlives the loop
    for (const core::Mark& mark : world->area.marks) {
        if (!mark.light) continue;
        EXPECT_TRUE(LightCharacter::parse(mark.light->character)) << mark.id;
    }
}

/// Colours seen from a bearing, one letter a light, sorted.
std::string seen(const std::vector<ShipLight>& lights, double bearing_deg) {
    std::string letters;
    for (const ShipLight& light : lights) {
        if (light.seenFrom(bearing_deg * kDegree_rad) < 0.99) continue;
        letters += light.colour[1] < 0.5 ? 'R' : light.colour[0] < 0.5 ? 'G' : 'W';
    }
    std::sort(letters.begin(), letters.end());
    return letters;
}

TEST(ShipLights, TheLessonsShipIsLongEnoughForTwoMastheadLights) {
    const ShipForm form = formOf(test::lessonWorld()->ships[0]->vessel);
    const auto lights = lightsOf(form, ShipActivity::UnderWay);
    EXPECT_EQ(seen(lights, 40.0), "GWW");
    EXPECT_EQ(seen(lights, -40.0), "RWW");
    EXPECT_EQ(seen(lights, 180.0), "W");  // sternlight
    EXPECT_EQ(seen(lights, 118.0), "W");
    EXPECT_EQ(seen(lights, 107.0), "GWW");
    EXPECT_EQ(seen(lightsOf(form, ShipActivity::Anchored), 77.0), "WW");
    EXPECT_GT(lights[1].position.up, lights[0].position.up + 4.4);
    EXPECT_LT(lights[1].position.x, lights[0].position.x);
}

TEST(ShipLights, ASmallCraftHasOneMastheadLightAndASailingYachtNone) {
    core::TargetLayout boat;
    boat.length_m = 12.0;
    EXPECT_EQ(seen(lightsOf(formOf(boat), ShipActivity::UnderWay), 30.0), "GW");
    boat.type = core::TargetType::Yacht;
    EXPECT_EQ(seen(lightsOf(formOf(boat), ShipActivity::UnderWay), 30.0), "G");
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
    const auto lights = lightsOf(form, ShipActivity::UnderWay);
    EXPECT_EQ(seen(lights, -40.0), "RWW");
    EXPECT_EQ(lights[0].position.up, 9.0);
    EXPECT_EQ(lights[1].position.x, -5.0);
    EXPECT_EQ(lights[2].position.y, -4.0);
    EXPECT_EQ(lights[3].position.y, 0.5 * form.beam_m);  // not placed: where it usually is
    EXPECT_EQ(lightsOf(form, ShipActivity::Anchored)[0].position.x, 24.0);
}

TEST(ShipLights, AYachtWithAMastheadLightIsUnderPower) {
    core::TargetLayout boat;
    boat.length_m = 12.0;
    boat.type = core::TargetType::Yacht;
    ShipForm form = formOf(boat);
    form.lights[static_cast<std::size_t>(core::LightPlace::MastheadForward)] = Point{1.0, 0.0, 8.0};
    EXPECT_EQ(seen(lightsOf(form, ShipActivity::UnderWay), 30.0), "GW");
}

TEST(Visibility, ALightIsSeenToItsNominalRangeInAClearNightAndNotBeyond) {
    // The table of annex I, section 8: 0.9, 4.3, 12, 52 and 94 candela for 1, 2, 3, 5 and 6 miles.
    const double clear = -std::log(0.8) / core::kNauticalMile_m;
    for (const auto& [range_M, strength_cd] :
         {std::pair{1.0, 0.9}, {2.0, 4.3}, {3.0, 12.0}, {5.0, 52.0}, {6.0, 94.0}}) {
        EXPECT_NEAR(candela(range_M) / strength_cd, 1.0, 0.06);  // the table is rounded
        const double at_m = range_M * core::kNauticalMile_m;
        EXPECT_GT(lookOf(illuminance_lux(candela(range_M), 0.97 * at_m, clear), 1.0).brightness, 0.0);
        EXPECT_EQ(lookOf(illuminance_lux(candela(range_M), 1.05 * at_m, clear), 1.0).brightness, 0.0);
    }
}

}  // namespace
}  // namespace sagara::render
