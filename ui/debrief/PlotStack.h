#pragma once

#include <QPixmap>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ui/debrief/Marks.h"
#include "ui/debrief/PlotData.h"
#include "ui/debrief/TimeAxis.h"
#include "ui/theme/PaletteName.h"

namespace sagara::ui {

/// Plots of one run, or of two, one under the other on the time of the timeline, with its cursor and what
/// they say there. A click goes to that moment; Ctrl and the wheel zoom.
class PlotStack final : public QWidget {
    Q_OBJECT

public:
    explicit PlotStack(TimeAxis& axis, QWidget* parent = nullptr);

    void setColours(PaletteName name);
    void setData(std::shared_ptr<const PlotData> run);
    /// A second run on the same axes; null: none.
    void setOther(std::shared_ptr<const PlotData> run);
    void setMarks(const std::vector<DebriefMark>& marks);  ///< deductions are shown
    void setShown(std::vector<PlotKind> kinds);
    const std::vector<PlotKind>& shown() const { return m_shown; }
    /// What is written at the cursor, for tests too: "5.8" or "ship 5.8, limit 6.0".
    QString reading(PlotKind kind) const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override { stale(); }
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void stale();
    QRectF plotArea(std::size_t index) const;
    PlotAxis axisOf(PlotKind kind) const;
    void drawPlot(QPainter& p, std::size_t index) const;
    void drawCurves(QPainter& p, const PlotData& run, PlotKind kind, bool other, const QRectF& area,
                    const PlotAxis& axis) const;
    QPen penOf(const PlotCurve& curve, std::size_t nth, bool other) const;
    QString readingOf(const PlotData& run, PlotKind kind) const;

    TimeAxis& m_axis;
    PaletteName m_colours = PaletteName::Day;
    std::shared_ptr<const PlotData> m_data, m_other;
    std::vector<DebriefMark> m_marks;
    std::vector<PlotKind> m_shown;
    QPixmap m_picture;  ///< all but the cursor; null: to be made
};

}  // namespace sagara::ui
