#pragma once

#include <QColor>
#include <array>

#include "ui/theme/PaletteName.h"

namespace sagara::ui {

/// Colours of everything that is not chart: the roles of the OpenBridge palettes (assets/themes). Opaque.
/// Words keep a contrast of 4.5 to 1 with what is behind them (a test sees to it): the published night
/// palette is meant for a dark bridge and is lifted to that, its hues kept.
struct ThemeColours {
    QColor window;   ///< behind everything
    QColor surface;  ///< panels, fields
    QColor section;  ///< headers, alternate rows
    QColor pressed;
    QColor text;
    QColor quietText;
    QColor disabledText;
    QColor line;    ///< dividers
    QColor border;  ///< of fields and buttons
    QColor focus;
    QColor selected;
    QColor onSelected;
    QColor setValue;  ///< what was ordered, on instruments
    QColor accent;    ///< what is drawn for emphasis
    QColor tick;      ///< scales of instruments
    QColor quietTick;
    QColor port;
    QColor starboard;
    QColor alarm, onAlarm;
    QColor warning, onWarning;
    QColor caution, onCaution;
    QColor running, onRunning;
    std::array<QColor, 4> series;  ///< lines of plots, told apart by the colour blind too
};

const ThemeColours& themeColours(PaletteName name);

/// Contrast of two opaque colours, 1 to 21: WCAG 2.1, "contrast ratio".
double contrast(const QColor& a, const QColor& b);

}  // namespace sagara::ui
