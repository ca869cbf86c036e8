#include "ui/widgets/CompassRose.h"

#include <cmath>

#include "core/base/Angle.h"
#include "ui/chart/Format.h"
#include "ui/widgets/ScreenText.h"

namespace sagara::ui {

void drawCompassRose(QPainter& painter, QPointF middle, double radius_px, double north_rad, const QColor& ink,
                     const QColor& halo) {
    painter.save();
    painter.translate(middle);
    painter.rotate(north_rad / core::kDegree_rad);
    const double letter = std::max(5.0, 0.11 * radius_px);
    painter.setBrush(Qt::NoBrush);
    for (const bool outline : {true, false}) {
        painter.setPen(QPen(outline ? halo : ink, outline ? 3.0 : 0.9));
        painter.drawEllipse(QPointF(), radius_px, radius_px);
        for (int degree = 0; degree < 360; degree += 2) {
            const double length = degree % 10 == 0 ? 0.12 : degree % 5 == 0 ? 0.08 : 0.05;
            if (outline && degree % 10 != 0) continue;
            const double a = degree * core::kDegree_rad;
            const QPointF way(std::sin(a), -std::cos(a));
            painter.drawLine((1.0 - length) * radius_px * way, radius_px * way);
        }
    }
    const Lettering letters{letter, ink, halo, false, false};
    for (int degree = 0; degree < 360; degree += 30) {
        const double a = degree * core::kDegree_rad;
        const QPointF at = (0.88 * radius_px - 0.75 * letter) * QPointF(std::sin(a), -std::cos(a));
        drawText(painter, at, Qt::AlignHCenter | Qt::AlignVCenter, chart::bearing(degree), letters, degree);
    }
    painter.setPen(QPen(ink, 0.8));
    painter.drawLine(QPointF(-0.2 * radius_px, 0.0), QPointF(0.2 * radius_px, 0.0));
    painter.drawLine(QPointF(0.0, 0.2 * radius_px), QPointF(0.0, -0.5 * radius_px));
    // The star of north stands outside of the ring.
    painter.setBrush(ink);
    const double tip = radius_px + 1.5 * letter;
    painter.drawPolygon(QPolygonF{QPointF(0.0, -tip), QPointF(-0.45 * letter, -radius_px),
                                  QPointF(0.45 * letter, -radius_px)});
    painter.restore();
}

}  // namespace sagara::ui
