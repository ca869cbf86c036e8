#pragma once

#include <QColor>

#include "ui/chart/Marks.h"
#include "ui/theme/PaletteName.h"

namespace sagara::ui {

/// Colours of the chart, in the manner of the IHO's S-52 tables: blue shades get paler as it gets deeper by
/// day and darker by night. Words keep a contrast of 4.5 to 1 with what is behind them (a test sees to it).
struct ChartPalette {
    QColor noDepths;  ///< where the area has no depth grid
    QColor drying;    ///< above chart datum
    QColor shallow;   ///< shallower than the first contour
    QColor unsafe;    ///< from there to the safety contour
    QColor safe;      ///< beyond the safety contour
    QColor deep;      ///< beyond twice its depth
    QColor land;
    QColor shore;  ///< coastline
    QColor quay;   ///< quays, jetties, breakwaters
    QColor berth;
    QColor contour;
    QColor safetyContour;
    QColor sounding;       ///< deeper than the safety contour
    QColor shoalSounding;  ///< not deeper
    QColor graticule;
    QColor ink;    ///< words on the chart
    QColor quiet;  ///< words that matter less
    QColor halo;   ///< behind words
    QColor place;  ///< names of anchorages
    QColor panel;
    QColor panelBorder;
    QColor panelInk;
    QColor panelQuiet;
    QColor ownShip;
    QColor hull;  ///< inside of ships drawn to scale
    QColor track;
    QColor prediction;
    QColor target;
    QColor hostile;
    QColor route;
    QColor corridor;
    QColor zone;
    QColor zoneDone;
    QColor limit;
    QColor tool;
    QColor flareWhite, flareRed, flareGreen;  ///< of lights
    chart::MarkColours marks;
};

const ChartPalette& chartPalette(PaletteName name);

}  // namespace sagara::ui
