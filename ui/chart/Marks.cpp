#include "ui/chart/Marks.h"

#include <QPainterPath>
#include <QPen>
#include <array>

#include "core/base/Units.h"

namespace sagara::chart {
namespace {

using core::MarkKind;
using Colour = ChartMark::Colour;

/// Widths of lines, of the size of the symbol.
constexpr double kMargin = 0.192, kOutline = 0.069, kCross = 0.154;

QPen linePen(const QColor& colour, double width) {
    return QPen(colour, width, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin);
}

QColor fillOf(Colour colour, const MarkColours& colours) {
    switch (colour) {
        case Colour::Red:
            return colours.red;
        case Colour::Green:
            return colours.green;
        case Colour::Yellow:
            return colours.yellow;
        case Colour::White:
            return colours.paper;
        case Colour::Black:
            break;
    }
    return colours.ink;
}

Colour colourOf(MarkKind kind, bool regionB) {
    switch (kind) {
        case MarkKind::LateralPort:
            return regionB ? Colour::Green : Colour::Red;
        case MarkKind::LateralStarboard:
            return regionB ? Colour::Red : Colour::Green;
        case MarkKind::SafeWater:
            return Colour::Red;
        case MarkKind::Special:
            return Colour::Yellow;
        case MarkKind::Lighthouse:
        case MarkKind::Leading:
            return Colour::White;
        default:
            return Colour::Black;
    }
}

/// A triangle with a horizontal base, its tip above (1) or below (-1) its middle.
QPainterPath cone(QPointF middle, double half, double up) {
    QPainterPath path;
    path.addPolygon(QPolygonF{middle + QPointF(-half, up * half * 0.8),
                              middle + QPointF(half, up * half * 0.8),
                              middle + QPointF(0.0, -up * half * 0.9)});
    path.closeSubpath();
    return path;
}

QPainterPath can(QPointF middle, double half) {
    QPainterPath path;
    path.addRect(QRectF(middle.x() - 0.8 * half, middle.y() - half, 1.6 * half, 2.0 * half));
    return path;
}

QPainterPath sphere(QPointF middle, double half) {
    QPainterPath path;
    path.addEllipse(middle, half, half);
    return path;
}

QPainterPath star(QPointF middle, double half) {
    QPainterPath path;
    for (int i = 0; i < 10; ++i) {
        const double reach = i % 2 == 0 ? 1.35 * half : 0.55 * half;
        const core::NorthEast ray = reach * core::unitVector(i * core::kPi / 5.0);
        const QPointF p = middle + QPointF(ray.east_m, -ray.north_m);
        i == 0 ? path.moveTo(p) : path.lineTo(p);
    }
    path.closeSubpath();
    return path;
}

QPainterPath saltire(QPointF middle, double half) {
    QPainterPath path;
    path.moveTo(middle + QPointF(-half, -half));
    path.lineTo(middle + QPointF(half, half));
    path.moveTo(middle + QPointF(half, -half));
    path.lineTo(middle + QPointF(-half, half));
    return path;
}

/// The two cones of a cardinal mark, upper and lower: points up, up: north; up, down: east; and so on.
QPainterPath cardinal(QPointF middle, double half, double upper, double lower) {
    const double small = 0.62 * half;
    QPainterPath path = cone(middle - QPointF(0.0, 1.1 * small), small, upper);
    path.addPath(cone(middle + QPointF(0.0, 1.1 * small), small, lower));
    return path;
}

QPainterPath twoSpheres(QPointF middle, double half) {
    const QPointF up(0.0, 0.6 * half);
    QPainterPath path = sphere(middle - up, 0.5 * half);
    path.addPath(sphere(middle + up, 0.5 * half));
    return path;
}

QPainterPath shapeOf(MarkKind kind, QPointF middle, double half) {
    switch (kind) {
        case MarkKind::LateralPort:
            return can(middle, half);
        case MarkKind::LateralStarboard:
            return cone(middle, half, 1.0);
        case MarkKind::CardinalNorth:
            return cardinal(middle, half, 1.0, 1.0);
        case MarkKind::CardinalEast:
            return cardinal(middle, half, 1.0, -1.0);
        case MarkKind::CardinalSouth:
            return cardinal(middle, half, -1.0, -1.0);
        case MarkKind::CardinalWest:
            return cardinal(middle, half, -1.0, 1.0);
        case MarkKind::IsolatedDanger:
            return twoSpheres(middle, half);
        case MarkKind::SafeWater:
            return sphere(middle, 0.85 * half);
        case MarkKind::Special:
            return saltire(middle, 0.8 * half);
        case MarkKind::Lighthouse:
            return star(middle, half);
        case MarkKind::Leading:
            return cone(middle, half, 1.0);
        case MarkKind::Beacon:
            break;
    }
    return sphere(middle, 0.6 * half);
}

}  // namespace

ChartMark chartMarkOf(const core::Mark& mark, std::string_view ialaRegion) {
    return {mark.name, mark.position, colourOf(mark.kind, ialaRegion == "B"), mark.fictional, mark.kind};
}

void drawMark(QPainter& painter, QPointF at, const ChartMark& mark, double size, const MarkColours& colours) {
    const QPainterPath shape = shapeOf(mark.kind, at, 0.5 * size);
    painter.setPen(linePen(colours.paper, kMargin * size));  // so that it stands out from lines below
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(shape);
    painter.setPen(linePen(colours.ink, (mark.kind == MarkKind::Special ? kCross : kOutline) * size));
    painter.setBrush(fillOf(mark.colour, colours));
    painter.drawPath(shape);
    if (mark.kind != MarkKind::SafeWater) return;
    painter.setBrush(colours.paper);
    painter.drawRect(QRectF(at.x() - 0.16 * size, at.y() - 0.4 * size, 0.32 * size, 0.8 * size));
}

}  // namespace sagara::chart
