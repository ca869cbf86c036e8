#pragma once

#include <QWidget>

#include "ui/theme/PaletteName.h"
#include "ui/trainee/ShipAlarms.h"

class QLabel;
class QPushButton;

namespace sagara::ui::console {

/// The ship's alarms in a line, red until they are acknowledged.
class AlarmStrip final : public QWidget {
    Q_OBJECT

public:
    explicit AlarmStrip(QWidget* parent = nullptr);
    void setColours(PaletteName name);
    void update(const AlarmInputs& now);
    using QWidget::update;
    const ShipAlarms& alarms() const { return m_alarms; }

public Q_SLOTS:
    void acknowledge();

Q_SIGNALS:
    /// The buzzer goes on or off.
    void sounding(bool on);

private:
    void refresh();

    ShipAlarms m_alarms;
    PaletteName m_palette = PaletteName::Day;
    bool m_sounding = false;
    QLabel* m_text;
    QPushButton* m_acknowledge;
};

}  // namespace sagara::ui::console
