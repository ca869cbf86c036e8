#pragma once

#include <QIcon>
#include <QPalette>
#include <QString>

#include "ui/theme/ThemeColours.h"

class QApplication;

namespace sagara::ui {

/// The palette of all ordinary widgets. Painted ones take themeColours themselves.
QPalette widgetPalette(PaletteName name);
/// What a QPalette cannot say: borders, sizes of buttons, tool tips.
QString styleSheet(PaletteName name);
/// Style, palette and style sheet of the whole program; again whenever the palette is changed.
void applyTheme(QApplication& application, PaletteName name);

/// An icon of assets/icons by the name of its file without ".svg", in the palette's colours. A name that is
/// not there gives an empty icon.
QIcon themedIcon(const QString& icon, PaletteName palette);

}  // namespace sagara::ui
