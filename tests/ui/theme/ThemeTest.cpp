#include <gtest/gtest.h>

#include "ui/theme/Theme.h"

namespace sagara::ui {
namespace {

class EveryPalette : public testing::TestWithParam<PaletteName> {};

TEST_P(EveryPalette, WordsCanBeRead) {
    const ThemeColours& c = themeColours(GetParam());
    for (const QColor& behind : {c.window, c.surface, c.section}) {
        for (const QColor& words : {c.text, c.quietText, c.setValue, c.accent, c.tick, c.port, c.starboard})
            EXPECT_GE(contrast(words, behind), 4.5)
                << words.name().toStdString() << " on " << behind.name().toStdString();
    }
    EXPECT_GE(contrast(c.disabledText, c.surface), 2.0);
    EXPECT_GE(contrast(c.border, c.surface), 1.6);
    EXPECT_GE(contrast(c.onSelected, c.selected), 4.5);
    EXPECT_GE(contrast(c.onAlarm, c.alarm), 4.5);
    EXPECT_GE(contrast(c.onWarning, c.warning), 4.5);
    EXPECT_GE(contrast(c.onCaution, c.caution), 4.5);
    EXPECT_GE(contrast(c.onRunning, c.running), 4.5);
}

TEST_P(EveryPalette, ColoursAreOpaque) {
    const ThemeColours& c = themeColours(GetParam());
    for (const QColor& colour : {c.window, c.line, c.border, c.disabledText, c.quietText, c.selected})
        EXPECT_EQ(colour.alpha(), 255);
}

INSTANTIATE_TEST_SUITE_P(, EveryPalette,
                         testing::Values(PaletteName::Day, PaletteName::Dusk, PaletteName::Night));

}  // namespace
}  // namespace sagara::ui
