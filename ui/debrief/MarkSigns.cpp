#include "ui/debrief/MarkSigns.h"

#include <QPainter>
#include <QPainterPath>

namespace sagara::ui {
namespace {

QPainterPath signOf(MarkKind kind, QPointF at, double h) {
    QPainterPath path;
    const double x = at.x(), y = at.y();
    switch (kind) {
        case MarkKind::Task:
            path.addEllipse(at, h, h);
            break;
        case MarkKind::Deduction:
            path.addPolygon(QPolygonF({{x - h, y - 0.8 * h}, {x + h, y - 0.8 * h}, {x, y + h}}));
            break;
        case MarkKind::Failure:
            path.addPolygon(QPolygonF({{x - 0.5 * h, y - h},
                                       {x + 0.5 * h, y - h},
                                       {x + h, y - 0.5 * h},
                                       {x + h, y + 0.5 * h},
                                       {x + 0.5 * h, y + h},
                                       {x - 0.5 * h, y + h},
                                       {x - h, y + 0.5 * h},
                                       {x - h, y - 0.5 * h}}));
            break;
        case MarkKind::Event:
            path.addPolygon(QPolygonF({{x, y - h}, {x + h, y}, {x, y + h}, {x - h, y}}));
            break;
        case MarkKind::Weather:
            path.addRoundedRect(QRectF(x - h, y - 0.6 * h, 2 * h, 1.2 * h), 0.6 * h, 0.6 * h);
            break;
        case MarkKind::Note:
            path.addPolygon(QPolygonF({{x - 0.7 * h, y - h},
                                       {x + 0.7 * h, y - h},
                                       {x + 0.7 * h, y + h},
                                       {x, y + 0.35 * h},
                                       {x - 0.7 * h, y + h}}));
            break;
    }
    path.closeSubpath();
    return path;
}

}  // namespace

QColor markColour(MarkKind kind, const ThemeColours& c) {
    switch (kind) {
        case MarkKind::Task:
            return c.starboard;
        case MarkKind::Deduction:
        case MarkKind::Failure:
            return c.port;
        case MarkKind::Event:
            return c.text;
        case MarkKind::Weather:
            return c.series[2];
        case MarkKind::Note:
            return c.accent;
    }
    return c.text;
}

void drawMarkSign(QPainter& painter, QPointF at, MarkKind kind, double half_px, const ThemeColours& colours) {
    painter.save();
    painter.setPen(QPen(colours.surface, 1.0));
    painter.setBrush(markColour(kind, colours));
    painter.drawPath(signOf(kind, at, half_px));
    painter.restore();
}

}  // namespace sagara::ui
