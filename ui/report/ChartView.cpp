#include "ui/report/ChartView.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sagara::report {
namespace {

constexpr std::array<double, 13> kFactors{1, 1.25, 1.5, 1.75, 2, 2.5, 3, 3.5, 4, 5, 6, 7.5, 10};

double decadeBelow(double value) { return std::pow(10.0, std::floor(std::log10(value))); }

}  // namespace

QPointF ChartView::toPage(core::NorthEast p) const {
    const core::NorthEast d = p - m_centre;
    return m_frame.center() + QPointF(toMm(d.east_m), -toMm(d.north_m));
}

core::NorthEast ChartView::toChart(QPointF p) const {
    const QPointF d = p - m_frame.center();
    return m_centre + core::NorthEast{-toMetres(d.y()), toMetres(d.x())};
}

QPolygonF ChartView::toPage(std::span<const core::NorthEast> line) const {
    QPolygonF polygon;
    polygon.reserve(static_cast<qsizetype>(line.size()));
    for (const core::NorthEast p : line) polygon << toPage(p);
    return polygon;
}

Extent ChartView::extent() const {
    Extent shown;
    shown.include(toChart(m_frame.topLeft()));
    shown.include(toChart(m_frame.bottomRight()));
    return shown;
}

double denominatorAtLeast(double least) {
    const double decade = decadeBelow(least);
    for (const double factor : kFactors) {
        if (factor * decade >= least * (1.0 - 1e-9)) return factor * decade;
    }
    return 10.0 * decade;
}

double denominatorAtMost(double most) {
    const double decade = decadeBelow(most);
    double best = decade;
    for (const double factor : kFactors) {
        if (factor * decade <= most * (1.0 + 1e-9)) best = factor * decade;
    }
    return best;
}

}  // namespace sagara::report
