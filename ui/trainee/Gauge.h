#pragma once

#include <QPainter>
#include <QWidget>
#include <optional>

#include "ui/theme/ThemeColours.h"

namespace sagara::ui::console {

/// Base of the painted instruments and controls: title, colours, and letters that grow with the widget.
/// Angles and speeds come in SI; degrees and knots are made when it is painted.
class Gauge : public QWidget {
    Q_OBJECT

public:
    Gauge(const QString& title, double shape, QWidget* parent = nullptr);

    virtual void setColours(PaletteName name);
    /// Wide over high, for layouts.
    QSize sizeHint() const override { return {static_cast<int>(100.0 * m_shape), 100}; }

protected:
    const ThemeColours& colours() const { return themeColours(m_palette); }
    PaletteName palette() const { return m_palette; }
    /// One hundredth of the height of a gauge: all sizes are in it.
    double unit() const { return 0.01 * height(); }
    /// Panel and title; what is left for the instrument.
    QRectF drawFrame(QPainter& painter) const;
    /// One line that never gets out of its box.
    void drawWords(QPainter& painter, const QRectF& box, Qt::Alignment alignment, const QString& words,
                   double size_px, const QColor& colour, bool bold = false) const;

private:
    QString m_title;
    double m_shape;
    PaletteName m_palette = PaletteName::Day;
};

/// "P 12" or "S 12", "0" within half a step.
QString sided(double value, int decimals);
/// A small triangle whose tip is at a point; `towards_deg` clockwise from up.
QPolygonF pointerAt(QPointF tip, double size, double towards_deg);

}  // namespace sagara::ui::console
