#pragma once

#include <QString>
#include <vector>

#include "ui/debrief/Replay.h"

namespace sagara::ui {

enum class PlotKind {
    SpeedOverGround,
    Heading,
    RateOfTurn,
    Rudder,
    Shafts,
    CrossTrack,
    UnderKeel,
    Roll,
    Pitch,
    ClearOfShips
};
inline constexpr int kPlotKinds = 10;

/// A line of a plot, in the unit it is shown in; not a number breaks it.
struct PlotCurve {
    enum class Style { Plain, Ordered, Limit };
    QString name;  ///< empty: it needs none
    Style style = Style::Plain;
    std::vector<float> values;  ///< one for each of PlotData::time_s
};

struct Plot {
    PlotKind kind = PlotKind::SpeedOverGround;
    std::vector<PlotCurve> curves;
};

/// Everything that can be plotted of a run, against its time.
struct PlotData {
    std::vector<double> time_s;
    std::vector<Plot> plots;  ///< by PlotKind

    const Plot& of(PlotKind kind) const { return plots[static_cast<std::size_t>(kind)]; }
    /// Index of the last sample not after a time; 0 before all.
    std::size_t at(double time_s) const;
};

/// Of the graded ship. `orders` may be null: then there are no curves of what was ordered. Takes some 10 ms
/// for an hour.
PlotData plotData(const core::World& world, const std::vector<core::TrackSample>& track,
                  const ReplayOrders* orders);

QString plotTitle(PlotKind kind);  ///< "Speed over ground, kn"
/// A value as it is written on axis and at the cursor.
QString plotFigure(PlotKind kind, double value, int decimals);
int plotDecimals(PlotKind kind);

struct PlotAxis {
    double low = 0.0;
    double high = 1.0;
    double step = 1.0;
    int decimals = 0;
};
/// An axis in round figures that holds all the curves, with `most` steps or fewer.
PlotAxis plotAxis(PlotKind kind, const std::vector<const Plot*>& plots, int most);

}  // namespace sagara::ui
