#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "ui/debrief/Marks.h"
#include "ui/debrief/TimeAxis.h"
#include "ui/theme/PaletteName.h"

namespace sagara::ui {

/// The run from end to end: tasks, deductions with their points, what happened, notes, each in its lane. A
/// click goes there: to the mark under it, else to the moment. Left and Right step, the wheel zooms.
class Timeline final : public QWidget {
    Q_OBJECT

public:
    explicit Timeline(TimeAxis& axis, QWidget* parent = nullptr);

    void setColours(PaletteName name);
    void setMarks(std::vector<DebriefMark> marks);
    const std::vector<DebriefMark>& marks() const { return m_marks; }
    /// Shades the part that was sailed anew.
    void setBranch(std::optional<core::SimTime> from);
    /// Where a mark is painted, for its tooltip and for tests.
    QPointF placeOf(const DebriefMark& mark) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    /// By the keys: so many seconds on.
    void stepWanted(double seconds);

protected:
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    const DebriefMark* markAt(QPointF at) const;
    QString tipAt(QPointF at) const;
    void drawPoints(QPainter& p) const;
    double laneHeight_px() const;
    double laneMiddle_px(int lane) const;

    TimeAxis& m_axis;
    PaletteName m_colours = PaletteName::Day;
    std::vector<DebriefMark> m_marks;
    std::optional<core::SimTime> m_branch;
};

}  // namespace sagara::ui
