#pragma once

#include <QSize>

namespace sagara::run {
class Store;
}

namespace sagara::station {

/// How much larger than usual text and controls are to be on a monitor which the desktop does not scale by
/// itself: 2 on 3840x2160. `logicalDpi`: dots per inch as the desktop says, 96 where it leaves sizes alone.
double monitorScale(QSize screen_px, double devicePixelRatio, double logicalDpi);

/// Before the QApplication: the size chosen in the settings, or what the first monitor asks for. Whoever has
/// set Qt's own scale (QT_SCALE_FACTOR and its kin) is left alone.
void scaleWindows(run::Store& store, bool hasDisplay, int argc, char** argv);

}  // namespace sagara::station
