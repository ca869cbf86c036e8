#pragma once

#include "ui/theme/ThemeColours.h"

namespace sagara::ui {

/// The colour of words and lines that say something is wrong: the alarm's where it can be read on a panel and
/// on the window, else a brighter one.
inline QColor wrongWords(PaletteName name) {
    const ThemeColours& c = themeColours(name);
    constexpr double kReadable = 4.5;
    for (const QColor& colour : {c.alarm, c.warning, c.series[3], c.series[1]})
        if (contrast(colour, c.surface) >= kReadable && contrast(colour, c.window) >= kReadable)
            return colour;
    return c.text;
}

}  // namespace sagara::ui
