#pragma once

#include <QWidget>

#include "ui/theme/PaletteName.h"
#include "ui/trainer/TraceSeries.h"

namespace sagara::ui {

/// VIEW: the traces, one strip below the other on one time axis, each with its name, its value now and its
/// unit.
class TraceBoard final : public QWidget {
    Q_OBJECT

public:
    explicit TraceBoard(QWidget* parent = nullptr);
    void setColours(PaletteName name);
    /// Drawn from what it is then; it outlives the widget.
    void setSeries(const TraceSeries* series) { m_series = series; }
    void setSpan(double span_s);
    double span_s() const { return m_span_s; }
    /// Name, value now and unit of a trace, as it is written.
    static QString title(Trace trace);
    QString valueNow(Trace trace) const;

    QSize minimumSizeHint() const override { return {240, 8 * 35 + 18}; }
    QSize sizeHint() const override { return {320, 8 * 52 + 18}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    PaletteName m_palette = PaletteName::Day;
    const TraceSeries* m_series = nullptr;
    double m_span_s = 120.0;
};

}  // namespace sagara::ui
