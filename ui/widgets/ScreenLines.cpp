#include "ui/widgets/ScreenLines.h"

#include <cmath>

namespace sagara::ui {
namespace {

constexpr double kFine_px = 0.7;  ///< points nearer to the last than this are left out

bool near(QPointF a, QPointF b) {
    return std::abs(a.x() - b.x()) < kFine_px && std::abs(a.y() - b.y()) < kFine_px;
}

QPolygonF thinned(const ChartTransform& view, std::span<const core::NorthEast> line) {
    QPolygonF thin;
    thin.reserve(static_cast<qsizetype>(line.size()));
    for (std::size_t i = 0; i < line.size(); ++i) {
        const QPointF p = view.toScreen(line[i]);
        if (thin.isEmpty() || i + 1 == line.size() || !near(thin.last(), p)) thin << p;
    }
    return thin;
}

/// One edge of the clip: the side of it on which `keep(p)` is not negative stays (Sutherland and Hodgman
/// 1974).
template <typename Keep>
QPolygonF cut(const QPolygonF& ring, Keep&& keep) {
    QPolygonF kept;
    kept.reserve(ring.size() + 4);
    for (qsizetype i = 0; i < ring.size(); ++i) {
        const QPointF a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
        const double ka = keep(a), kb = keep(b);
        if (ka >= 0.0) kept << a;
        if ((ka >= 0.0) != (kb >= 0.0)) kept << a + (b - a) * (ka / (ka - kb));
    }
    return kept;
}

bool outside(QPointF a, QPointF b, const QRectF& clip) {
    return (a.x() < clip.left() && b.x() < clip.left()) || (a.x() > clip.right() && b.x() > clip.right()) ||
           (a.y() < clip.top() && b.y() < clip.top()) || (a.y() > clip.bottom() && b.y() > clip.bottom());
}

}  // namespace

QPolygonF screenRing(const ChartTransform& view, std::span<const core::NorthEast> ring, const QRectF& clip) {
    QPolygonF polygon = thinned(view, ring);
    if (polygon.size() < 3 || clip.contains(polygon.boundingRect())) return polygon;
    polygon = cut(polygon, [&](QPointF p) { return p.x() - clip.left(); });
    polygon = cut(polygon, [&](QPointF p) { return clip.right() - p.x(); });
    polygon = cut(polygon, [&](QPointF p) { return p.y() - clip.top(); });
    return cut(polygon, [&](QPointF p) { return clip.bottom() - p.y(); });
}

QList<QPolygonF> screenPieces(const ChartTransform& view, std::span<const core::NorthEast> line,
                              const QRectF& clip) {
    QList<QPolygonF> pieces;
    QPolygonF piece;
    const QPolygonF thin = thinned(view, line);
    for (qsizetype i = 1; i < thin.size(); ++i) {
        if (outside(thin[i - 1], thin[i], clip)) {
            if (!piece.isEmpty()) pieces << std::exchange(piece, {});
            continue;
        }
        if (piece.isEmpty()) piece << thin[i - 1];
        piece << thin[i];
    }
    if (!piece.isEmpty()) pieces << piece;
    return pieces;
}

bool meets(const chart::Extent& a, const chart::Extent& b) {
    return !a.empty && !b.empty && a.southWest.north_m <= b.northEast.north_m &&
           b.southWest.north_m <= a.northEast.north_m && a.southWest.east_m <= b.northEast.east_m &&
           b.southWest.east_m <= a.northEast.east_m;
}

}  // namespace sagara::ui
