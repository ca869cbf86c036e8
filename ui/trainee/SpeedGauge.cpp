#include "ui/trainee/SpeedGauge.h"

#include <cmath>

#include "core/base/Units.h"
#include "ui/chart/Format.h"

namespace sagara::ui::console {

SpeedGauge::SpeedGauge(QWidget* parent) : Gauge(tr("Speed kn"), 1.9, parent) {
    setToolTip(
        tr("Left: speed over the ground in knots and course made good. Right: speed through the water "
           "ahead in knots, below it athwart"));
}

void SpeedGauge::setOverGround(double speed_mps, std::optional<double> course_rad) {
    m_overGround_mps = speed_mps;
    m_course_rad = course_rad;
    update();
}

void SpeedGauge::setThroughWater(double ahead_mps, double toStarboard_mps) {
    m_ahead_mps = ahead_mps;
    m_toStarboard_mps = toStarboard_mps;
    update();
}

void SpeedGauge::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF box = drawFrame(painter);
    const double half = 0.5 * box.width();
    const auto column = [&](double left, const QString& name, double speed_mps, const QString& below) {
        const QRectF at(left, box.top(), half - 6.0, box.height());
        drawWords(painter, QRectF(at.left(), at.top(), at.width(), 14.0 * unit()),
                  Qt::AlignLeft | Qt::AlignVCenter, name, 10.5 * unit(), colours().quietText);
        drawWords(painter, QRectF(at.left(), at.top() + 15.0 * unit(), at.width(), 34.0 * unit()),
                  Qt::AlignLeft | Qt::AlignVCenter, chart::number(speed_mps / core::kKnot_mps, 1),
                  32.0 * unit(), colours().text, true);
        drawWords(painter, QRectF(at.left(), at.bottom() - 17.0 * unit(), at.width(), 15.0 * unit()),
                  Qt::AlignLeft | Qt::AlignVCenter, below, 13.0 * unit(), colours().text);
    };
    column(box.left(), tr("over ground"), m_overGround_mps,
           m_course_rad ? tr("course %1°T").arg(chart::bearing(*m_course_rad / core::kDegree_rad))
                        : tr("course none"));
    column(box.left() + half + 4.0, tr("through water"), m_ahead_mps,
           tr("athwart %1").arg(sided(m_toStarboard_mps / core::kKnot_mps, 1)));
    painter.setPen(QPen(colours().line, 1.0));
    painter.drawLine(QPointF(box.left() + half - 3.0, box.top()),
                     QPointF(box.left() + half - 3.0, box.bottom()));
}

}  // namespace sagara::ui::console
