#pragma once

#include <QString>
#include <QVector>

#include "ui/hints/Hints.h"

namespace sagara::ui {

struct HintLine {
    QString name;    ///< "Next waypoint"
    QString value;   ///< "Entrance"
    QString detail;  ///< "285°T, 0.42 M, 4 min"; may be empty
    bool urgent = false;
};

/// "0.42 M"; under two cables in metres, "180 m".
QString hintDistance(double distance_m);
/// "4 min", "under 1 min", "1 h 05 min".
QString hintDuration(double time_s);
/// "6 kn", "5.5 kn".
QString hintSpeed(double speed_mps);

/// The hints in words, most pressing first. `speed_mps` over the ground, to tell when she is too fast.
QVector<HintLine> hintLines(const Hints& hints, double speed_mps);

}  // namespace sagara::ui
