#pragma once

#include <QObject>
#include <QString>

#include "core/base/SimTime.h"

namespace sagara::ui {

/// The time that timeline and plots share: from when to when they show, and where the replay is.
class TimeAxis final : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    void setWhole(core::SimTime begin, core::SimTime end);  ///< shows all of it
    core::SimTime begin() const { return m_begin; }
    core::SimTime end() const { return m_end; }
    double from_s() const { return m_from_s; }
    double to_s() const { return m_to_s; }
    bool zoomed() const;

    void setCursor(core::SimTime time);
    core::SimTime cursor() const { return m_cursor; }

    /// Nearer (over 1) or farther; the moment stays where it is. Shows ten seconds at least.
    void zoom(double about_s, double factor);
    void scroll(double by_s);
    void showAll();

    /// Where a moment lies in a widget that keeps kLeft_px and kRight_px free.
    double x(double time_s, double width_px) const;
    double time_s(double x_px, double width_px) const;
    core::SimTime timeAt(double x_px, double width_px) const;  ///< to the tick, within the whole
    /// Seconds between two figures of the axis, so that they lie `apart_px` apart or more.
    double step_s(double width_px, double apart_px) const;

    static constexpr double kLeft_px = 96.0;
    static constexpr double kRight_px = 18.0;

Q_SIGNALS:
    void rangeChanged();
    void cursorChanged();
    /// A person points at a moment, in whichever widget.
    void picked(core::SimTime time);

private:
    void setRange(double from_s, double to_s);

    core::SimTime m_begin, m_end, m_cursor;
    double m_from_s = 0.0;
    double m_to_s = 1.0;
};

/// "12:05", "1:02:05".
QString axisTime(double time_s);

}  // namespace sagara::ui
