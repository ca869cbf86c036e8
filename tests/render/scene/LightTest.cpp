#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/base/Units.h"
#include "core/world/LightCharacter.h"
#include "render/scene/light/Visibility.h"
#include "tests/support/exercise/Lesson.h"

namespace sagara::render {
namespace {

using core::LightCharacter;

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
