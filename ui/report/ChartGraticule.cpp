#include <QPolygonF>
#include <array>
#include <cmath>
#include <functional>

#include "core/base/Units.h"
#include "ui/report/Chart.h"
#include "ui/report/Format.h"

namespace sagara::report {
namespace {

constexpr double kLeastSpacing_mm = 34.0;
const TextStyle kTextStyle{6.5, colour::kInk};

/// Distance of the lines in minutes of arc.
double step_min(const ChartView& view) {
    constexpr std::array<double, 14> kSteps_min{0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 20, 30, 60};
    for (const double step : kSteps_min) {
        if (view.toMm(step * core::kNauticalMile_m) >= kLeastSpacing_mm) return step;
    }
    return 60.0;
}

/// One meridian or parallel across the frame.
struct GridLine {
    double value_deg = 0.0;
    core::NorthEast from, to;
};

/// All values that are multiples of the step between two angles.
std::vector<double> multiples(double low_deg, double high_deg, double step_deg) {
    std::vector<double> values;
    for (double k = std::ceil(low_deg / step_deg); k * step_deg <= high_deg && values.size() < 100; ++k) {
        values.push_back(k * step_deg);
    }
    return values;
}

/// In a frame of a few miles meridians and parallels are straight to a hair's breadth.
std::vector<GridLine> parallels(const Chart& chart, double ofStep = 1.0) {
    const Extent shown = chart.view.extent();
    const core::GeoPoint sw = chart.report.frame.toGeo(shown.southWest),
                         ne = chart.report.frame.toGeo(shown.northEast);
    std::vector<GridLine> lines;
    for (const double lat : multiples(sw.lat_deg, ne.lat_deg, ofStep * step_min(chart.view) / 60.0)) {
        lines.push_back({lat, chart.report.frame.toLocal({lat, sw.lon_deg}),
                         chart.report.frame.toLocal({lat, ne.lon_deg})});
    }
    return lines;
}

std::vector<GridLine> meridians(const Chart& chart, double ofStep = 1.0) {
    const Extent shown = chart.view.extent();
    const core::GeoPoint sw = chart.report.frame.toGeo(shown.southWest),
                         ne = chart.report.frame.toGeo(shown.northEast);
    std::vector<GridLine> lines;
    for (const double lon : multiples(sw.lon_deg, ne.lon_deg, ofStep * step_min(chart.view) / 60.0)) {
        lines.push_back({lon, chart.report.frame.toLocal({sw.lat_deg, lon}),
                         chart.report.frame.toLocal({ne.lat_deg, lon})});
    }
    return lines;
}

int decimals(const ChartView& view) { return step_min(view) < 0.0999 ? 2 : 1; }

}  // namespace

void drawGraticule(Chart& chart) {
    chart.painter.setPen(linePen(colour::kRule, 0.1));
    for (const GridLine& line : parallels(chart))
        chart.painter.drawLine(chart.view.toPage(line.from), chart.view.toPage(line.to));
    for (const GridLine& line : meridians(chart))
        chart.painter.drawLine(chart.view.toPage(line.from), chart.view.toPage(line.to));
}

/// Ticks on the inside of the border, five to a line of the graticule.
void drawBorderTicks(Chart& chart) {
    constexpr double kTick_mm = 1.2;
    const QRectF& frame = chart.view.frame();
    chart.painter.setPen(linePen(colour::kInk, 0.15));
    for (const GridLine& line : parallels(chart, 0.2)) {
        const double y_mm = chart.view.toPage(line.from).y();
        chart.painter.drawLine(QPointF(frame.left(), y_mm), QPointF(frame.left() + kTick_mm, y_mm));
        chart.painter.drawLine(QPointF(frame.right(), y_mm), QPointF(frame.right() - kTick_mm, y_mm));
    }
    for (const GridLine& line : meridians(chart, 0.2)) {
        const double x_mm = chart.view.toPage(line.from).x();
        chart.painter.drawLine(QPointF(x_mm, frame.top()), QPointF(x_mm, frame.top() + kTick_mm));
        chart.painter.drawLine(QPointF(x_mm, frame.bottom()), QPointF(x_mm, frame.bottom() - kTick_mm));
    }
}

void drawGraticuleTexts(Chart& chart) {
    const QRectF& frame = chart.view.frame();
    for (const GridLine& line : parallels(chart)) {
        const double y_mm = chart.view.toPage(line.from).y();
        const QString words = latitude(line.value_deg, decimals(chart.view));
        if (y_mm < frame.top() + 9.0 || y_mm > frame.bottom() - 9.0) continue;
        drawText(chart.painter, {frame.left() - 1.2, y_mm}, Qt::AlignHCenter, words, kTextStyle, -90.0);
    }
    for (const GridLine& line : meridians(chart)) {
        const double x_mm = chart.view.toPage(line.from).x();
        if (x_mm < frame.left() + 9.0 || x_mm > frame.right() - 9.0) continue;
        drawText(chart.painter, {x_mm, frame.bottom() + 3.2}, Qt::AlignHCenter,
                 longitude(line.value_deg, decimals(chart.view)), kTextStyle);
    }
}

}  // namespace sagara::report
