#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <optional>
#include <vector>

namespace sagara::report {

/// Finds places for labels on a chart: never over each other or over what is blocked, and rather not over the
/// lines. Labels that matter most are placed first.
class LabelField {
public:
    explicit LabelField(const QRectF& frame) : m_frame(frame) {}

    void block(const QRectF& area) { m_blocked.push_back(area); }
    /// A point of a line, better not covered.
    void avoid(QPointF point) { m_lines.push_back(point); }
    bool isFree(const QRectF& area) const;

    /// The best place for a label of a size, its nearest side `gap_mm` to `reach_mm` away from a point;
    /// blocked from now on.
    std::optional<QRectF> place(QPointF point, QSizeF size, double gap_mm, double reach_mm);

private:
    double cost(const QRectF& area, double distance_mm) const;

    QRectF m_frame;
    std::vector<QRectF> m_blocked;
    std::vector<QPointF> m_lines;
};

}  // namespace sagara::report
