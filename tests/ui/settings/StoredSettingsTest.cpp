#include "ui/settings/StoredSettings.h"

#include <gtest/gtest.h>

namespace sagara::ui {
namespace {

TEST(StoredSettings, ComeBackAsTheyWereLeft) {
    MemorySettings store;
    {
        BridgeInput input;
        SoundBoard sound;
        sound.setMuted(true);
        sound.setVolume(0.35);
        storeSound(store, sound);
        KeyMap keys = usualKeys();
        keys[0].key = QKeySequence(Qt::Key_F7);
        storeKeys(store, keys);
        ControlMap map = usualMap(2, 2, 0);
        map.axes[1].use = AxisUse::Telegraph;
        storeMap(store, "abc", map);
        storeMap(store, "def", usualMap(1, 0, 0));
        storeMap(store, "abc", map);
        NmeaSettings nmea;
        nmea.output_Hz = 4;
        storeNmea(store, nmea);
        storePalette(store, PaletteName::Night);
        storeSize_percent(store, 150);
    }
    BridgeInput input;
    SoundBoard sound;
    applySettings(store, input, sound);
    EXPECT_TRUE(sound.muted());
    EXPECT_DOUBLE_EQ(sound.volume(), 0.35);
    EXPECT_EQ(input.keys()[0].key, QKeySequence(Qt::Key_F7));
    EXPECT_EQ(input.mapOf({0, "abc", {}, 2, 2, 0}).axes[1].use, AxisUse::Telegraph);
    EXPECT_EQ(input.nmea().settings().output_Hz, 4);
    EXPECT_EQ(storedPalette(store), PaletteName::Night);
    EXPECT_EQ(storedSize_percent(store), 150);
    storeSize_percent(store, std::nullopt);
    EXPECT_EQ(storedSize_percent(store), std::nullopt);
    EXPECT_EQ(store.get("input.devices"), "abc def");
}

TEST(StoredSettings, NonsenseCountsAsNotThere) {
    MemorySettings store;
    for (const char* key : {"sound.volume_percent", "sound.muted", "input.keys", "input.nmea",
                            "display.palette", "demo.pin", "demo.chord"})
        store.put(key, "\xff{nonsense");
    store.put("input.devices", "x y");
    store.put("input.device.x", "{");
    BridgeInput input;
    SoundBoard sound;
    applySettings(store, input, sound);
    EXPECT_DOUBLE_EQ(sound.volume(), 0.7);
    EXPECT_FALSE(sound.muted());
    EXPECT_EQ(input.keys(), usualKeys());
    EXPECT_EQ(storedPalette(store), PaletteName::Day);
    EXPECT_EQ(storedPin(store), QStringLiteral("0000"));
    EXPECT_EQ(storedChord(store), usualDemoChord());
}

TEST(StoredSettings, ThePinIsDigitsAndTheChordNeedsTwoHands) {
    EXPECT_TRUE(isPin(QStringLiteral("0000")));
    EXPECT_TRUE(isPin(QStringLiteral("12345678")));
    for (const char* text : {"", "123", "123456789", "12a4", "12 4"})
        EXPECT_FALSE(isPin(QString::fromLatin1(text))) << text;
    EXPECT_TRUE(isChord(usualDemoChord()));
    EXPECT_FALSE(isChord(QKeySequence(Qt::CTRL | Qt::Key_Q)));
    EXPECT_FALSE(isChord(QKeySequence(Qt::Key_Q)));
    EXPECT_FALSE(isChord({}));
    MemorySettings store;
    storeChord(store, QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_F12));
    EXPECT_EQ(store.get("demo.chord"), "Ctrl+Alt+F12");
}

}  // namespace
}  // namespace sagara::ui
