#pragma once

#include "ui/trainee/Gauge.h"

namespace sagara::ui::console {

/// Base of what a hand moves: drag, mouse wheel or ↑ ↓ with the focus a step at a time, double click. Those
/// that derive show what others order only while it is not held.
class Lever : public Gauge {
    Q_OBJECT

public:
    Lever(const QString& title, double shape, QWidget* parent = nullptr);
    bool held() const { return m_held; }

protected:
    /// The hand is at this point of the widget; `held()` is false when it gets there, true while it drags.
    virtual void take(QPointF p) = 0;
    /// Mouse wheel away from the hand and ↑ are positive.
    virtual void stepUp(int steps) = 0;
    /// Double click; false where it means no more than two clicks.
    virtual bool rest() { return false; }
    /// Brush and pen of what is moved.
    void prepareKnob(QPainter& painter) const;

    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent*) override { m_held = false; }
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    bool m_held = false;
};

}  // namespace sagara::ui::console
