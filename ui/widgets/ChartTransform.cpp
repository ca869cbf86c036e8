#include "ui/widgets/ChartTransform.h"

#include <algorithm>
#include <cmath>

namespace sagara::ui {

using core::NorthEast;

ChartTransform::ChartTransform(QSizeF size_px, NorthEast centre, double metresPerPixel, double up_rad)
    : m_size(size_px),
      m_centre(centre),
      m_metresPerPixel(std::clamp(metresPerPixel, kNearest_mPerPixel, kFarthest_mPerPixel)),
      m_up_rad(up_rad),
      m_up(core::unitVector(up_rad)) {}

QPointF ChartTransform::toScreen(NorthEast p) const {
    const NorthEast d = p - m_centre;
    return middle() + QPointF(core::cross(m_up, d), -core::dot(m_up, d)) / m_metresPerPixel;
}

NorthEast ChartTransform::toChart(QPointF p) const {
    const QPointF d = m_metresPerPixel * (p - middle());
    return m_centre - d.y() * m_up + d.x() * core::turnedRight(m_up);
}

chart::Extent ChartTransform::extent() const {
    chart::Extent shown;
    for (const double x : {0.0, m_size.width()}) {
        for (const double y : {0.0, m_size.height()}) shown.include(toChart({x, y}));
    }
    return shown;
}

ChartTransform ChartTransform::panned(QPointF by_px) const { return centredOn(toChart(middle() - by_px)); }

ChartTransform ChartTransform::zoomed(QPointF about, double factor) const {
    const ChartTransform scaled(m_size, m_centre, m_metresPerPixel / factor, m_up_rad);
    return scaled.centredOn(m_centre + (toChart(about) - scaled.toChart(about)));
}

ChartTransform ChartTransform::resized(QSizeF size_px) const {
    return {size_px, m_centre, m_metresPerPixel, m_up_rad};
}

ChartTransform ChartTransform::turned(double up_rad) const {
    return {m_size, m_centre, m_metresPerPixel, up_rad};
}

ChartTransform ChartTransform::centredOn(NorthEast p) const {
    return {m_size, p, m_metresPerPixel, m_up_rad};
}

}  // namespace sagara::ui
