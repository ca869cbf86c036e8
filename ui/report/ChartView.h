#pragma once

#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <span>

#include "ui/chart/Extent.h"

namespace sagara::report {

using chart::Extent;

/// Frame N drawn north up, to a scale, in a rectangle of the page.
class ChartView {
public:
    /// 1 : denominator, with `centre` in the middle of the frame.
    ChartView(const QRectF& frame, core::NorthEast centre, double denominator)
        : m_frame(frame), m_centre(centre), m_denominator(denominator) {}

    const QRectF& frame() const { return m_frame; }
    double denominator() const { return m_denominator; }
    core::NorthEast centre() const { return m_centre; }
    double toMm(double length_m) const { return 1000.0 * length_m / m_denominator; }
    double toMetres(double length_mm) const { return 0.001 * length_mm * m_denominator; }

    QPointF toPage(core::NorthEast p) const;
    core::NorthEast toChart(QPointF p) const;
    QPolygonF toPage(std::span<const core::NorthEast> line) const;
    bool holds(core::NorthEast p) const { return m_frame.contains(toPage(p)); }
    /// What the frame shows.
    Extent extent() const;

private:
    QRectF m_frame;
    core::NorthEast m_centre;
    double m_denominator;
};

/// Denominators people are used to: 1, 1.25, 1.5, 1.75, 2, 2.5, 3, 3.5, 4, 5, 6, 7.5 and their tenfolds.
double denominatorAtLeast(double least);
double denominatorAtMost(double most);

}  // namespace sagara::report
