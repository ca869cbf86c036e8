#pragma once

#include <QPainter>
#include <QPainterPath>
#include <QRectF>
#include <optional>

#include "ui/chart/LabelField.h"
#include "ui/report/ChartView.h"
#include "ui/report/ReportData.h"
#include "ui/report/Text.h"

namespace sagara::report {

/// A chart while it is drawn: first every layer of lines and areas, then the labels, those that matter most
/// first.
struct Chart {
    Chart(QPainter& onPainter, const ChartView& in, const RunReport& of)
        : painter(onPainter), view(in), report(of), labels(in.frame()) {}

    QPainter& painter;
    const ChartView& view;
    const RunReport& report;
    chart::LabelField labels;
    std::optional<QRectF> shownInInset;  ///< a part of the frame whose details are in the inset

    /// Whether a place's label or symbol belongs on this chart.
    bool details(QPointF p) const {
        return view.frame().contains(p) && !(shownInInset && shownInInset->contains(p));
    }
    bool details(core::NorthEast p) const { return details(view.toPage(p)); }
};

/// Places and draws a text of one or two lines near a point; nothing when there is no room. A line leads to a
/// point that is not next to it.
void labelNear(Chart& chart, QPointF point, double gap_mm, double reach_mm, const QString& text,
               const TextStyle& style);

// layers, from the bottom up
void drawSea(Chart& chart);
void drawContours(Chart& chart);
void drawLand(Chart& chart);
void drawGraticule(Chart& chart);
void drawCorridor(Chart& chart);
void drawRoute(Chart& chart);
void drawOtherTracks(Chart& chart);
void drawMarks(Chart& chart);
void drawTrack(Chart& chart);
void drawAnchors(Chart& chart);

// labels, from the most important down
void labelDeductions(Chart& chart);
void labelWaypoints(Chart& chart);
void labelAnchors(Chart& chart);
void labelTimes(Chart& chart);
void labelMarks(Chart& chart);
void labelOtherTracks(Chart& chart);
void labelContours(Chart& chart);

/// Seconds between two outlines of the ship on this chart.
double outlineInterval_s(const Chart& chart);

void drawBorderTicks(Chart& chart);
/// Latitudes to the left of the frame and longitudes below it.
void drawGraticuleTexts(Chart& chart);

}  // namespace sagara::report
