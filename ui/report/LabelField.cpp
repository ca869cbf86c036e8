#include "ui/report/LabelField.h"

#include <algorithm>
#include <array>

namespace sagara::report {
namespace {

constexpr double kStep_mm = 1.5;
constexpr double kPerLinePoint = 2.0;  ///< as bad as so many mm of distance

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

double LabelField::cost(const QRectF& area, double distance_mm) const {
    const auto covered =
        std::count_if(m_lines.begin(), m_lines.end(), [&](QPointF p) { return area.contains(p); });
    return distance_mm + kPerLinePoint * static_cast<double>(covered);
}

std::optional<QRectF> LabelField::place(QPointF point, QSizeF size, double gap_mm, double reach_mm) {
    std::optional<QRectF> best;
    double bestCost = 1e18;
    for (double away_mm = gap_mm; away_mm <= reach_mm && away_mm < bestCost; away_mm += kStep_mm) {
        for (const auto& [x, y] : kDirections) {
            QRectF area(QPointF(), size);
            area.moveCenter(point +
                            QPointF(x * (away_mm + 0.5 * size.width()), y * (away_mm + 0.5 * size.height())));
            if (!isFree(area)) continue;
            const double here = cost(area, away_mm);
            if (here >= bestCost) continue;
            bestCost = here;
            best = area;
        }
    }
    if (best) block(*best);
    return best;
}

}  // namespace sagara::report
