#include "ui/sound/SoundMixer.h"

#include <gtest/gtest.h>

#include "Listening.h"

namespace sagara::ui {
namespace {

SoundScene everything() {
    SoundScene scene;
    scene.engines = {{120.0, 84.0, 1.0, true}, {120.0, 84.0, 1.0, true}};
    scene.wash = scene.bowWave = scene.wind = scene.rain = 1.0;
    scene.blades_Hz = 8.0;
    scene.horn = scene.bell = scene.alarm = true;
    scene.cableLinks_Hz = 30.0;
    for (std::size_t i = 0; i < kMostHeard; ++i)
        scene.others.push_back({i, {100.0, 0.0, 5.0}, 200.0, true, true, true});
    return scene;
}

std::vector<float> heard(SoundMixer& mixer, std::size_t source, double length_s) {
    return test::seconds(length_s, [&](Samples s) { mixer.fill(source, s); });
}

TEST(SoundMixer, AnEmptySceneIsSilent) {
    SoundMixer mixer;
    mixer.show({});
    std::vector<float> block(1024);
    for (std::size_t i = 0; i < SoundMixer::kSources; ++i) EXPECT_FALSE(mixer.fill(i, block)) << i;
}

TEST(SoundMixer, EverySourceIsHeardAndNoneClips) {
    SoundMixer mixer;
    mixer.show(everything());
    for (std::size_t i = 0; i < SoundMixer::kSources; ++i) {
        const auto sound = heard(mixer, i, 2.0);
        EXPECT_GT(test::loudness(sound), 0.004) << i;
        EXPECT_LE(test::peak(sound), 1.0) << i;
        const auto placing = mixer.placing(i);
        EXPECT_GT(placing.gain, 0.0);
        EXPECT_GT(placing.fullWithin_m, 0.0);
    }
}

TEST(SoundMixer, UnderWayNothingDrownsTheRestAndTheHornIsLoudest) {
    SoundScene scene;  // eight knots, twelve metres of wind a second over the deck, some rain
    scene.engines = {{90.0, 45.0, 0.45, true}, {90.0, 45.0, 0.45, true}};
    scene.wash = 0.45;
    scene.blades_Hz = 6.0;
    scene.bowWave = 0.5;
    scene.wind = 0.45;
    scene.rain = 0.4;
    scene.horn = scene.alarm = true;
    SoundMixer mixer;
    mixer.show(scene);
    for (std::size_t i = 0; i < SoundMixer::FirstOther; ++i) heard(mixer, i, 2.0);
    const auto level = [&](std::size_t source) {
        return mixer.placing(source).gain * test::loudness(heard(mixer, source, 4.0));
    };
    const double horn = level(SoundMixer::Horn);
    for (const auto source : {SoundMixer::Engines, SoundMixer::Wash, SoundMixer::BowWave, SoundMixer::Wind,
                              SoundMixer::Rain, SoundMixer::Alarm}) {
        const double below_dB = 20.0 * std::log10(horn / level(source));
        EXPECT_GT(below_dB, 0.0) << source;
        EXPECT_LT(below_dB, 34.0) << source;  // 40 dB below would not be heard beside it
    }
}

TEST(SoundMixer, WhatStopsDiesAwayAndIsNotFedAnyMore) {
    SoundMixer mixer;
    mixer.show(everything());
    for (std::size_t i = 0; i < SoundMixer::kSources; ++i) heard(mixer, i, 1.0);
    mixer.show({});
    std::vector<float> block(1024);
    for (std::size_t i = 0; i < SoundMixer::kSources; ++i) {
        const bool pauses = i == SoundMixer::Alarm;  // between its tones it is silent by itself
        EXPECT_TRUE(mixer.fill(i, block) || pauses) << i << " breaks off";
        bool goesOn = true;
        for (int k = 0; k < 20 * kSampleRate_Hz / 1024 && goesOn; ++k) goesOn = mixer.fill(i, block);
        EXPECT_FALSE(goesOn) << i;
    }
}

TEST(SoundMixer, DoorsLetTheWeatherIn) {
    SoundScene scene;
    scene.wind = scene.rain = 0.8;
    SoundMixer inside;
    inside.show(scene);
    scene.listener.outside = true;
    SoundMixer outside;
    outside.show(scene);
    for (int i = 0; i < 3; ++i)  // the doors go with the first source
        for (SoundMixer* const mixer : {&inside, &outside}) heard(*mixer, SoundMixer::Engines, 1.0);
    EXPECT_GT(test::loudness(heard(outside, SoundMixer::Rain, 2.0)),
              1.5 * test::loudness(heard(inside, SoundMixer::Rain, 2.0)));
}

TEST(SoundMixer, AShipKeepsItsVoiceWhenAnotherComesNearer) {
    SoundMixer mixer;
    SoundScene scene;
    scene.others = {{7, {500.0, 0.0, 5.0}, 200.0, true, false, false}};
    mixer.show(scene);
    const double was_m = mixer.placing(SoundMixer::FirstOther).at.forward_m;
    scene.others.insert(scene.others.begin(), {9, {100.0, 0.0, 5.0}, 300.0, true, false, false});
    mixer.show(scene);
    EXPECT_EQ(mixer.placing(SoundMixer::FirstOther).at.forward_m, was_m);
    EXPECT_EQ(mixer.placing(SoundMixer::FirstOther + 1).at.forward_m, 100.0);
}

TEST(SoundMixer, WindComesFromWhereItBlows) {
    SoundMixer mixer;
    SoundScene scene;
    scene.wind = 0.5;
    scene.windFrom_rad = 0.5 * std::numbers::pi;
    mixer.show(scene);
    EXPECT_GT(mixer.placing(SoundMixer::Wind).at.starboard_m, 5.0);
    EXPECT_NEAR(mixer.placing(SoundMixer::Wind).at.forward_m, 0.0, 1e-9);
}

TEST(ToInt16, IsFullScaleAndNeverWrapsRound) {
    const std::vector<float> in{0.0F, 1.0F, -1.0F, 7.0F, 0.5F};
    std::vector<std::int16_t> out(in.size());
    toInt16(in, out);
    EXPECT_EQ(out, (std::vector<std::int16_t>{0, 32767, -32767, 32767, 16384}));
}

}  // namespace
}  // namespace sagara::ui
