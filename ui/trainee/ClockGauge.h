#pragma once

#include "ui/trainee/Gauge.h"

namespace sagara::ui::console {

/// Local time of the area, and UTC.
class ClockGauge final : public Gauge {
public:
    /// `zone`: "UTC+05:30".
    explicit ClockGauge(const QString& zone, QWidget* parent = nullptr);
    void setTimes(const QString& local, const QString& utc);

protected:
    void paintEvent(QPaintEvent*) override;

private:
    QString m_zone, m_local, m_utc;
};

}  // namespace sagara::ui::console
