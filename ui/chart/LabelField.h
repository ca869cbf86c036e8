#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <optional>
#include <vector>

namespace sagara::chart {

/// Finds places for labels on a chart: never over each other or over what is blocked, and rather not over the
/// lines. Labels that matter most are placed first.
class LabelField {
public:
    /// `step`: between the distances that are tried; a point of a line that a label would cover counts as
    /// much as a little more than one step. Any unit, the same in every call.
    explicit LabelField(const QRectF& frame, double step = 1.5) : m_frame(frame), m_step(step) {}

    void block(const QRectF& area) { m_blocked.push_back(area); }
    /// A point of a line, better not covered.
    void avoid(QPointF point) { m_lines.push_back(point); }
    bool isFree(const QRectF& area) const;
    /// Free, and over no point of a line.
    bool isClear(const QRectF& area) const;
    /// All that is blocked, in the order it came.
    const std::vector<QRectF>& blocked() const { return m_blocked; }

    /// The best place for a label of a size, its nearest side `gap` to `reach` away from a point;
    /// blocked from now on.
    std::optional<QRectF> place(QPointF point, QSizeF size, double gap, double reach);

private:
    double cost(const QRectF& area, double distance) const;

    QRectF m_frame;
    double m_step;
    std::vector<QRectF> m_blocked;
    std::vector<QPointF> m_lines;
};

}  // namespace sagara::chart
