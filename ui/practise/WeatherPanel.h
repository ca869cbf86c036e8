#pragma once

#include <QWidget>

#include "ui/practise/FreeSail.h"

class QComboBox;
class QDoubleSpinBox;
class QSpinBox;
class QTimeEdit;

namespace sagara::ui {

/// Wind, swell, visibility, rain and the hour of an exercise.
class WeatherPanel final : public QWidget {
    Q_OBJECT

public:
    explicit WeatherPanel(QWidget* parent = nullptr);
    void setWeather(const SailWeather& weather);
    SailWeather weather() const;
    void setUtcOffset(int minutes);  ///< of the area: the hour is local

Q_SIGNALS:
    void changed();

private:
    int m_utcOffset_min = 0;
    QString m_date = QStringLiteral("2027-01-15");  ///< local
    QSpinBox* m_wind;
    QSpinBox* m_windFrom;
    QDoubleSpinBox* m_swell;
    QSpinBox* m_period;
    QSpinBox* m_swellFrom;
    QDoubleSpinBox* m_visibility;
    QComboBox* m_rain;
    QTimeEdit* m_time;
};

}  // namespace sagara::ui
