#include "ui/report/TurningDrawing.h"

#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "ui/report/Axis.h"
#include "ui/report/Style.h"
#include "ui/report/Text.h"

namespace sagara::report {
namespace {

constexpr double kAdvanceLimit_L = 4.5, kDiameterLimit_L = 5.0;
const TextStyle kTickStyle{7.0, colour::kQuiet};
const TextStyle kLimitStyle{7.0, colour::kFailed};

/// Metres of the poster in the frame of the approach, as a place on the page.
struct Poster {
    QPointF origin;
    double mmPerMetre;
    QPointF at(QPointF p) const { return {origin.x() + mmPerMetre * p.x(), origin.y() - mmPerMetre * p.y()}; }
};

void drawTrack(QPainter& painter, const Poster& poster, const std::vector<QPointF>& track,
               const QColor& colour, bool dashed) {
    QPolygonF line;
    for (const QPointF p : track) line << poster.at(p);
    painter.setPen(dashed ? dashedPen(colour, 0.5, 2.0, 1.2) : linePen(colour, 0.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
}

}  // namespace

void drawTurningCircles(QPainter& painter, const QRectF& area, const PilotCardData::Condition& turns,
                        double L) {
    if (turns.starboard.empty() || L <= 0.0) {
        drawText(painter, area.center(), Qt::AlignCenter, tr("The turning circles were not reached."),
                 kTickStyle);
        return;
    }
    double left = -kDiameterLimit_L * L, right = -left, top = kAdvanceLimit_L * L, bottom = -0.6 * L;
    for (const auto* track : {&turns.starboard, &turns.port}) {
        for (const QPointF p : *track) {
            left = std::min(left, p.x());
            right = std::max(right, p.x());
            top = std::max(top, p.y());
            bottom = std::min(bottom, p.y());
        }
    }
    left -= 0.3 * L, right += 0.3 * L, top += 0.5 * L;
    Poster poster;
    poster.mmPerMetre =
        std::min((area.width() - 8.0) / (right - left), (area.height() - 8.0) / (top - bottom));
    poster.origin = {area.center().x() - 0.5 * poster.mmPerMetre * (left + right),
                     area.center().y() + 0.5 * poster.mmPerMetre * (top + bottom)};
    painter.fillRect(area, colour::kWater);
    painter.save();
    painter.setClipRect(area);
    for (double x = std::ceil(left / L) * L; x <= right; x += L) {
        painter.setPen(linePen(std::abs(x) < 0.5 ? colour::kOther : colour::kGrid, 0.15));
        painter.drawLine(poster.at({x, bottom}), poster.at({x, top}));
    }
    for (double y = std::ceil(bottom / L) * L; y <= top; y += L) {
        painter.setPen(linePen(std::abs(y) < 0.5 ? colour::kOther : colour::kGrid, 0.15));
        painter.drawLine(poster.at({left, y}), poster.at({right, y}));
        drawText(painter, poster.at({0.0, y}) + QPointF(-1.2, -0.6), Qt::AlignRight,
                 tr("%1 L").arg(std::round(y / L)), kTickStyle);
    }
    painter.setPen(dashedPen(colour::kFailed, 0.3, 2.4, 1.6));
    painter.drawLine(poster.at({left, kAdvanceLimit_L * L}), poster.at({right, kAdvanceLimit_L * L}));
    for (const double side : {-1.0, 1.0})
        painter.drawLine(poster.at({side * kDiameterLimit_L * L, bottom}),
                         poster.at({side * kDiameterLimit_L * L, top}));
    drawTrack(painter, poster, turns.starboard, colour::kRoute, false);
    drawTrack(painter, poster, turns.port, colour::kHostile, true);
    painter.setBrush(colour::kRoute);
    painter.setPen(Qt::NoPen);
    for (const QPointF p : turns.starboardTimes) painter.drawEllipse(poster.at(p), 0.7, 0.7);
    const double half = 0.5 * L, beam = 0.085 * L;
    QPolygonF ship;
    for (const QPointF p : {QPointF(0, half), QPointF(beam, 0.6 * half), QPointF(beam, -half),
                            QPointF(-beam, -half), QPointF(-beam, 0.6 * half)})
        ship << poster.at(p);
    painter.setPen(linePen(colour::kInk, 0.25));
    painter.setBrush(colour::kHull);
    painter.drawPolygon(ship);
    painter.restore();
    drawHaloText(painter, poster.at({right, kAdvanceLimit_L * L}) + QPointF(-1.0, -1.0), Qt::AlignRight,
                 tr("IMO advance 4.5 L"), kLimitStyle);
    for (const double side : {-1.0, 1.0})
        drawHaloText(painter,
                     {poster.at({side * kDiameterLimit_L * L, 0.0}).x() - side * 1.0, area.bottom() - 2.0},
                     side < 0.0 ? Qt::AlignLeft : Qt::AlignRight, tr("tactical diameter 5 L"), kLimitStyle);
    drawHaloText(painter, area.topLeft() + QPointF(2.0, 4.5), Qt::AlignLeft,
                 tr("grid: one length, %1 m").arg(L, 0, 'f', 1), kTickStyle);
    painter.setPen(linePen(colour::kRule, 0.2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(area);
}

}  // namespace sagara::report
