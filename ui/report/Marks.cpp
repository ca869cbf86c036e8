#include "ui/report/Marks.h"

#include <QPainterPath>
#include <array>

#include "core/base/Units.h"
#include "ui/report/Style.h"

namespace sagara::report {
namespace {

using core::MarkKind;
using Colour = ChartMark::Colour;

constexpr QColor kRed{0xc8, 0x1e, 0x1e}, kGreen{0x12, 0x82, 0x3c}, kYellow{0xf2, 0xc1, 0x1d};

QColor fillOf(Colour colour) {
    switch (colour) {
        case Colour::Red:
            return kRed;
        case Colour::Green:
            return kGreen;
        case Colour::Yellow:
            return kYellow;
        case Colour::White:
            return colour::kPaper;
        case Colour::Black:
            break;
    }
    return colour::kInk;
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
QPainterPath cone(QPointF middle, double half_mm, double up) {
    QPainterPath path;
    path.addPolygon(QPolygonF{middle + QPointF(-half_mm, up * half_mm * 0.8),
                              middle + QPointF(half_mm, up * half_mm * 0.8),
                              middle + QPointF(0.0, -up * half_mm * 0.9)});
    path.closeSubpath();
    return path;
}

QPainterPath can(QPointF middle, double half_mm) {
    QPainterPath path;
    path.addRect(QRectF(middle.x() - 0.8 * half_mm, middle.y() - half_mm, 1.6 * half_mm, 2.0 * half_mm));
    return path;
}

QPainterPath sphere(QPointF middle, double half_mm) {
    QPainterPath path;
    path.addEllipse(middle, half_mm, half_mm);
    return path;
}

QPainterPath star(QPointF middle, double half_mm) {
    QPainterPath path;
    for (int i = 0; i < 10; ++i) {
        const double reach_mm = i % 2 == 0 ? 1.35 * half_mm : 0.55 * half_mm;
        const core::NorthEast ray = reach_mm * core::unitVector(i * core::kPi / 5.0);
        const QPointF p = middle + QPointF(ray.east_m, -ray.north_m);
        i == 0 ? path.moveTo(p) : path.lineTo(p);
    }
    path.closeSubpath();
    return path;
}

QPainterPath saltire(QPointF middle, double half_mm) {
    QPainterPath path;
    path.moveTo(middle + QPointF(-half_mm, -half_mm));
    path.lineTo(middle + QPointF(half_mm, half_mm));
    path.moveTo(middle + QPointF(half_mm, -half_mm));
    path.lineTo(middle + QPointF(-half_mm, half_mm));
    return path;
}

/// The two cones of a cardinal mark, upper and lower: points up, up: north; up, down: east; and so on.
QPainterPath cardinal(QPointF middle, double half_mm, double upper, double lower) {
    const double small_mm = 0.62 * half_mm;
    QPainterPath path = cone(middle - QPointF(0.0, 1.1 * small_mm), small_mm, upper);
    path.addPath(cone(middle + QPointF(0.0, 1.1 * small_mm), small_mm, lower));
    return path;
}

QPainterPath twoSpheres(QPointF middle, double half_mm) {
    const QPointF up(0.0, 0.6 * half_mm);
    QPainterPath path = sphere(middle - up, 0.5 * half_mm);
    path.addPath(sphere(middle + up, 0.5 * half_mm));
    return path;
}

QPainterPath shapeOf(MarkKind kind, QPointF middle, double half_mm) {
    switch (kind) {
        case MarkKind::LateralPort:
            return can(middle, half_mm);
        case MarkKind::LateralStarboard:
            return cone(middle, half_mm, 1.0);
        case MarkKind::CardinalNorth:
            return cardinal(middle, half_mm, 1.0, 1.0);
        case MarkKind::CardinalEast:
            return cardinal(middle, half_mm, 1.0, -1.0);
        case MarkKind::CardinalSouth:
            return cardinal(middle, half_mm, -1.0, -1.0);
        case MarkKind::CardinalWest:
            return cardinal(middle, half_mm, -1.0, 1.0);
        case MarkKind::IsolatedDanger:
            return twoSpheres(middle, half_mm);
        case MarkKind::SafeWater:
            return sphere(middle, 0.85 * half_mm);
        case MarkKind::Special:
            return saltire(middle, 0.8 * half_mm);
        case MarkKind::Lighthouse:
            return star(middle, half_mm);
        case MarkKind::Leading:
            return cone(middle, half_mm, 1.0);
        case MarkKind::Beacon:
            break;
    }
    return sphere(middle, 0.6 * half_mm);
}

}  // namespace

ChartMark chartMarkOf(const core::Mark& mark, std::string_view ialaRegion) {
    return {mark.name, mark.position, colourOf(mark.kind, ialaRegion == "B"), mark.fictional, mark.kind};
}

void drawMark(QPainter& painter, QPointF at, const ChartMark& mark, double size_mm) {
    const QPainterPath shape = shapeOf(mark.kind, at, 0.5 * size_mm);
    painter.setPen(linePen(colour::kPaper, 0.5));  // a margin, so that it stands out from lines below
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(shape);
    painter.setPen(linePen(colour::kInk, mark.kind == MarkKind::Special ? 0.4 : 0.18));
    painter.setBrush(fillOf(mark.colour));
    painter.drawPath(shape);
    if (mark.kind != MarkKind::SafeWater) return;
    painter.setBrush(colour::kPaper);
    painter.drawRect(QRectF(at.x() - 0.16 * size_mm, at.y() - 0.4 * size_mm, 0.32 * size_mm, 0.8 * size_mm));
}

}  // namespace sagara::report
