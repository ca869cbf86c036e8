#include "ui/settings/AxisBar.h"

#include <QPainter>

#include "ui/theme/ThemeColours.h"

namespace sagara::ui {

AxisBar::AxisBar(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(
        tr("Bar: calibrated, from the middle to either end. Mark below: raw reading between the ends "
           "that were found."));
}

void AxisBar::setColours(PaletteName palette) {
    m_palette = palette;
    update();
}

void AxisBar::show(const AxisCalibration& calibration, double raw) {
    if (raw == m_raw && calibration == m_calibration) return;
    m_raw = raw;
    m_calibration = calibration;
    m_value = usable(calibration) ? calibrated(calibration, raw) : 0.0;
    update();
}

void AxisBar::paintEvent(QPaintEvent*) {
    const ThemeColours& c = themeColours(m_palette);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF track(0.5, 2.5, width() - 1.0, height() - 10.0);
    const auto at = [&track](double value) { return track.left() + 0.5 * (value + 1.0) * track.width(); };
    painter.setPen(c.border);
    painter.setBrush(c.surface);
    painter.drawRoundedRect(track, 3.0, 3.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.setValue);
    const double from = std::min(at(0.0), at(m_value));
    const double to = std::max(at(0.0), at(m_value));
    painter.drawRect(QRectF(from, track.top() + 2.0, std::max(2.0, to - from), track.height() - 4.0));
    painter.setPen(c.quietTick);
    painter.drawLine(QPointF(at(0.0), track.top()), QPointF(at(0.0), track.bottom()));
    // Ends and dead zone of the raw reading, and where it is.
    const double below = track.bottom() + 3.5;
    const double half = m_calibration.deadZone;
    painter.setPen(QPen(c.quietTick, 1.0));
    painter.drawLine(QPointF(at(m_calibration.least), below), QPointF(at(m_calibration.most), below));
    painter.setPen(QPen(c.quietTick, 3.0));
    painter.drawLine(
        QPointF(at(m_calibration.centre - half * (m_calibration.centre - m_calibration.least)), below),
        QPointF(at(m_calibration.centre + half * (m_calibration.most - m_calibration.centre)), below));
    painter.setPen(Qt::NoPen);
    painter.setBrush(c.text);
    const double x = std::clamp(at(m_raw), 4.0, width() - 4.0);
    painter.drawPolygon(QPolygonF({{x, below - 3.0}, {x - 4.0, below + 4.0}, {x + 4.0, below + 4.0}}));
}

}  // namespace sagara::ui
