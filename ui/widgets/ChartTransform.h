#pragma once

#include <QPointF>
#include <QSizeF>

#include "core/base/Planar.h"
#include "ui/chart/Extent.h"

namespace sagara::ui {

/// Frame N as it lies on a screen of logical pixels, x to the right, y down. A value: every change gives a
/// new one. Use ChartCamera where the view has to follow a ship.
class ChartTransform {
public:
    /// `up_rad`: the direction that points up the screen, clockwise from north of frame N.
    ChartTransform(QSizeF size_px, core::NorthEast centre, double metresPerPixel, double up_rad = 0.0);

    QSizeF size() const { return m_size; }
    QPointF middle() const { return {0.5 * m_size.width(), 0.5 * m_size.height()}; }
    core::NorthEast centre() const { return m_centre; }
    double metresPerPixel() const { return m_metresPerPixel; }
    double up_rad() const { return m_up_rad; }
    double toPixels(double length_m) const { return length_m / m_metresPerPixel; }
    double toMetres(double length_px) const { return length_px * m_metresPerPixel; }

    QPointF toScreen(core::NorthEast p) const;
    core::NorthEast toChart(QPointF p) const;
    /// The box in frame N that holds all the screen shows.
    chart::Extent extent() const;
    /// The natural scale is 1 to this on a screen whose logical pixels are so many millimetres apart.
    double denominator(double pixel_mm) const { return 1000.0 * m_metresPerPixel / pixel_mm; }

    /// The chart dragged by so much.
    ChartTransform panned(QPointF by_px) const;
    /// Nearer (factor over 1) or farther; the place under `about` stays there. Within kNearest and kFarthest.
    ChartTransform zoomed(QPointF about, double factor) const;
    ChartTransform resized(QSizeF size_px) const;
    ChartTransform turned(double up_rad) const;
    ChartTransform centredOn(core::NorthEast p) const;

    static constexpr double kNearest_mPerPixel = 0.05;
    static constexpr double kFarthest_mPerPixel = 100.0;

private:
    QSizeF m_size;
    core::NorthEast m_centre;
    double m_metresPerPixel;
    double m_up_rad;
    core::NorthEast m_up;  ///< unit vector
};

}  // namespace sagara::ui
