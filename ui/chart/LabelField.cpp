#include "ui/chart/LabelField.h"

#include <algorithm>
#include <array>

namespace sagara::chart {
namespace {

constexpr double kPerLinePoint = 4.0 / 3.0;  ///< as bad as so many steps of distance

/// Directions on the side of a square, so that the label never reaches back over its point. The first of
/// equals wins: to the right, then left, below, above, then the corners and what lies between.
constexpr std::array<std::array<double, 2>, 16> kDirections{{{1, 0},
                                                             {-1, 0},
                                                             {0, 1},
                                                             {0, -1},
                                                             {1, -1},
                                                             {1, 1},
                                                             {-1, -1},
                                                             {-1, 1},
                                                             {1, -0.5},
                                                             {1, 0.5},
                                                             {-1, -0.5},
                                                             {-1, 0.5},
                                                             {0.5, 1},
                                                             {-0.5, 1},
                                                             {0.5, -1},
                                                             {-0.5, -1}}};

}  // namespace

bool LabelField::isFree(const QRectF& area) const {
    return m_frame.contains(area) &&
           std::none_of(m_blocked.begin(), m_blocked.end(),
                        [&](const QRectF& other) { return other.intersects(area); });
}

bool LabelField::isClear(const QRectF& area) const {
    return isFree(area) &&
           std::none_of(m_lines.begin(), m_lines.end(), [&](QPointF p) { return area.contains(p); });
}

double LabelField::cost(const QRectF& area, double distance) const {
    const auto covered =
        std::count_if(m_lines.begin(), m_lines.end(), [&](QPointF p) { return area.contains(p); });
    return distance + kPerLinePoint * m_step * static_cast<double>(covered);
}

std::optional<QRectF> LabelField::place(QPointF point, QSizeF size, double gap, double reach) {
    std::optional<QRectF> best;
    double bestCost = 1e18;
    for (double away = gap; away <= reach && away < bestCost; away += m_step) {
        for (const auto& [x, y] : kDirections) {
            QRectF area(QPointF(), size);
            area.moveCenter(point +
                            QPointF(x * (away + 0.5 * size.width()), y * (away + 0.5 * size.height())));
            if (!isFree(area)) continue;
            const double here = cost(area, away);
            if (here >= bestCost) continue;
            bestCost = here;
            best = area;
        }
    }
    if (best) block(*best);
    return best;
}

}  // namespace sagara::chart
