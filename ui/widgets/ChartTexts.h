#pragma once

#include <QString>

#include "ui/widgets/ChartScene.h"
#include "ui/widgets/Measure.h"
#include "ui/widgets/PreparedChart.h"

/// What the chart says in words.
namespace sagara::ui {

/// "006°01.95'N 080°13.60'E"
QString positionText(const core::LocalFrame& frame, core::NorthEast p);
/// "045°T"
QString bearingText(double bearing_rad);
/// "1.23 M 12.3 cables"
QString distanceText(double distance_m);
/// "045°T 1.23 M 12.3 cables"
QString rangeBearingText(const RangeBearing& measured);
/// "8.9 m", "dries 0.5 m", "land", or "no depth" beyond the grids. Depths are cut off, not rounded up.
QString depthText(const PreparedChart& chart, core::NorthEast p);
/// "8.0 kn"
QString speedText(double speed_mps);
/// "09:05" of a time of day; goes round at midnight.
QString clockText(double timeOfDay_s);

/// Name, course and speed over ground, length: for a tooltip.
QString shipText(const core::LocalFrame& frame, const ChartShip& ship);
QString markText(const core::Mark& mark);
QString berthText(const core::Berth& berth, const QString& datum);

/// "Depths in metres below LAT, modelled." and where they come from.
QString depthNote(const core::Area& area);

}  // namespace sagara::ui
