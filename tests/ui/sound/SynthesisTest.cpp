#include "ui/sound/Synthesis.h"

#include <gtest/gtest.h>

#include "Listening.h"

namespace sagara::ui {
namespace {

using test::at;
using test::largestStep;
using test::loudness;
using test::peak;
using test::seconds;

constexpr NoiseVoice::Colour kWater{100.0, 800.0, 1.0, 0.3, 0.5, 0.0};

TEST(Synthesis, EngineSoundsAtItsFiringFrequencyAndFallsSilentWhenStopped) {
    EngineVoice engine(1);
    seconds(2.0, [&](Samples s) { engine.fill(s, 90.0, 0.8); });
    const auto running = seconds(2.0, [&](Samples s) { engine.fill(s, 90.0, 0.8); });
    EXPECT_GT(at(running, 90.0), 5.0 * at(running, 97.0));
    EXPECT_GT(at(running, 15.0) + at(running, 75.0) + at(running, 105.0), 3.0 * at(running, 97.0));
    EXPECT_GT(loudness(running), 0.02);
    seconds(3.0, [&](Samples s) { engine.fill(s, 0.0, 0.0); });
    EXPECT_LT(peak(seconds(0.5, [&](Samples s) { engine.fill(s, 0.0, 0.0); })), 1e-4);
}

TEST(Synthesis, MoreLoadIsLouder) {
    EngineVoice easy(1);
    EngineVoice hard(1);
    seconds(2.0, [&](Samples s) { easy.fill(s, 60.0, 0.1); });
    seconds(2.0, [&](Samples s) { hard.fill(s, 60.0, 1.0); });
    EXPECT_GT(loudness(seconds(1.0, [&](Samples s) { hard.fill(s, 60.0, 1.0); })),
              1.3 * loudness(seconds(1.0, [&](Samples s) { easy.fill(s, 60.0, 0.1); })));
}

TEST(Synthesis, WaterGrowsLouderAndBrighterWithItsLevel) {
    NoiseVoice little(5, kWater);
    NoiseVoice much(5, kWater);
    seconds(1.0, [&](Samples s) { little.fill(s, 0.2); });
    seconds(1.0, [&](Samples s) { much.fill(s, 1.0); });
    const auto quiet = seconds(2.0, [&](Samples s) { little.fill(s, 0.2); });
    const auto loud = seconds(2.0, [&](Samples s) { much.fill(s, 1.0); });
    EXPECT_GT(loudness(loud), 3.0 * loudness(quiet));
    EXPECT_GT(test::crossings_Hz(loud), 1.5 * test::crossings_Hz(quiet));
}

TEST(Synthesis, BladesBeatInTheWash) {
    NoiseVoice wash(9, {200.0, 200.0, 1.0, 0.0, 1.0, 0.8});
    seconds(1.0, [&](Samples s) { wash.fill(s, 1.0, 8.0); });
    auto power = seconds(4.0, [&](Samples s) { wash.fill(s, 1.0, 8.0); });
    for (float& x : power) x *= x;
    EXPECT_GT(at(power, 8.0), 3.0 * at(power, 6.3));
}

TEST(Synthesis, HornHasItsPitchAndHarmonicsAndStops) {
    HornVoice horn(3);
    seconds(0.5, [&](Samples s) { horn.fill(s, 220.0, true); });
    const auto sounding = seconds(1.0, [&](Samples s) { horn.fill(s, 220.0, true); });
    EXPECT_GT(at(sounding, 220.0), 0.1);
    EXPECT_GT(at(sounding, 440.0), 10.0 * at(sounding, 470.0));
    seconds(1.0, [&](Samples s) { horn.fill(s, 220.0, false); });
    EXPECT_LT(peak(seconds(0.2, [&](Samples s) { horn.fill(s, 220.0, false); })), 1e-4);
}

TEST(Synthesis, WhistlesKeepToAnnexIII) {
    EXPECT_GE(whistlePitch_Hz(250.0), 70.0);
    EXPECT_LE(whistlePitch_Hz(250.0), 200.0);
    EXPECT_GE(whistlePitch_Hz(100.0), 130.0);
    EXPECT_LE(whistlePitch_Hz(100.0), 350.0);
    EXPECT_GE(whistlePitch_Hz(40.0), 250.0);
    EXPECT_LE(whistlePitch_Hz(40.0), 700.0);
}

TEST(Synthesis, TheBellIsStruckFourTimesASecondAndDiesAway) {
    BellVoice bell(BellVoice::Kind::Bell);
    auto ringing = seconds(3.0, [&](Samples s) { bell.fill(s, true); });
    EXPECT_GT(at(ringing, 520.0), 5.0 * at(ringing, 470.0));
    for (float& x : ringing) x *= x;
    EXPECT_GT(at(ringing, 4.0), 2.0 * at(ringing, 3.1));
    const auto after = seconds(12.0, [&](Samples s) { bell.fill(s, false); });
    EXPECT_GT(std::abs(after[3200]), 0.0F);  // still rings a tenth of a second later
    EXPECT_LT(peak({after.end() - 3200, after.end()}), 1e-4);
}

TEST(Synthesis, CableKnocksLinkByLink) {
    CableVoice running(7);
    CableVoice slow(7);
    seconds(0.5, [&](Samples s) { running.fill(s, 30.0); });
    seconds(0.5, [&](Samples s) { slow.fill(s, 2.0); });
    EXPECT_GT(loudness(seconds(2.0, [&](Samples s) { running.fill(s, 30.0); })),
              1.5 * loudness(seconds(2.0, [&](Samples s) { slow.fill(s, 2.0); })));
    seconds(2.0, [&](Samples s) { running.fill(s, 0.0); });
    EXPECT_LT(peak(seconds(0.2, [&](Samples s) { running.fill(s, 0.0); })), 1e-4);
}

TEST(Synthesis, TheAlarmRepeatsEveryTwoSeconds) {
    AlarmVoice alarm;
    seconds(2.0, [&](Samples s) { alarm.fill(s, true); });
    const auto one = seconds(2.0, [&](Samples s) { alarm.fill(s, true); });
    const auto other = seconds(2.0, [&](Samples s) { alarm.fill(s, true); });
    double apart = 0.0;
    for (std::size_t i = 0; i < one.size(); ++i)
        apart = std::max(apart, static_cast<double>(std::abs(one[i] - other[i])));
    EXPECT_LT(apart, 1e-3);
    EXPECT_GT(at(one, 1000.0), 0.03);
    EXPECT_LT(peak({one.begin() + 40'000, one.begin() + 60'000}), 1e-3);  // the pause
}

TEST(Synthesis, BlocksJoinWhateverTheirLength) {
    EngineVoice whole(1);
    EngineVoice pieces(1);
    HornVoice wholeHorn(1);
    HornVoice pieceHorn(1);
    const auto a = seconds(
        1.0, [&](Samples s) { whole.fill(s, 70.0, 0.5); }, 32'000);
    const auto b = seconds(
        1.0, [&](Samples s) { pieces.fill(s, 70.0, 0.5); }, 77);
    EXPECT_EQ(a, b);
    const auto c = seconds(
        1.0, [&](Samples s) { wholeHorn.fill(s, 220.0, true); }, 32'000);
    const auto d = seconds(
        1.0, [&](Samples s) { pieceHorn.fill(s, 220.0, true); }, 501);
    EXPECT_EQ(c, d);
}

TEST(Synthesis, NothingClipsAndNothingClicksHoweverItIsWorked) {
    EngineVoice engine(1);
    NoiseVoice water(2, kWater);
    HornVoice horn(3);
    BellVoice bell(BellVoice::Kind::Bell);
    BellVoice gong(BellVoice::Kind::Gong);
    AlarmVoice alarm;
    int round = 0;
    const auto on = [&round] { return (round / 7) % 2 == 0; };
    struct Case {
        const char* name;
        std::vector<float> heard;
        double step;  ///< largest between two samples that is still the sound itself
    };
    const double tone = 2.0 * std::numbers::pi / kSampleRate_Hz;
    const Case cases[] = {{"engine",
                           seconds(4.0,
                                   [&](Samples s) {
                                       engine.fill(s, on() ? 120.0 : 0.0, on() ? 1.0 : 0.0);
                                       ++round;
                                   }),
                           0.2},
                          {"water",
                           seconds(4.0,
                                   [&](Samples s) {
                                       water.fill(s, on() ? 1.0 : 0.0);
                                       ++round;
                                   }),
                           0.5},
                          {"horn",
                           seconds(4.0,
                                   [&](Samples s) {
                                       horn.fill(s, 400.0, on());
                                       ++round;
                                   }),
                           8.0 * tone * 400.0},
                          {"bell",
                           seconds(4.0,
                                   [&](Samples s) {
                                       bell.fill(s, on());
                                       ++round;
                                   }),
                           2.0 * tone * 1560.0},
                          {"gong",
                           seconds(4.0,
                                   [&](Samples s) {
                                       gong.fill(s, on());
                                       ++round;
                                   }),
                           2.0 * tone * 611.0},
                          {"alarm",
                           seconds(4.0,
                                   [&](Samples s) {
                                       alarm.fill(s, on());
                                       ++round;
                                   }),
                           2.0 * tone * 1000.0}};
    for (const Case& c : cases) {
        EXPECT_LE(peak(c.heard), 1.0) << c.name;
        EXPECT_LT(largestStep(c.heard), c.step) << c.name;
        for (const float x : c.heard) ASSERT_TRUE(std::isfinite(x)) << c.name;
    }
}

TEST(Synthesis, TheSameSeedIsTheSameSound) {
    NoiseVoice one(4, kWater);
    NoiseVoice two(4, kWater);
    EXPECT_EQ(seconds(0.5, [&](Samples s) { one.fill(s, 0.5); }),
              seconds(0.5, [&](Samples s) { two.fill(s, 0.5); }));
}

}  // namespace
}  // namespace sagara::ui
