#pragma once

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "ui/run/ExerciseRun.h"

class QCheckBox;
class QComboBox;
class QPushButton;
class QVBoxLayout;

namespace sagara::ui {

class WeatherBox;

/// What the trainer does to the exercise: events of the scenario, faults, weather, difficulty. Every control
/// gives an order and nothing else, and shows what is, whoever ordered it.
class EventBoard final : public QWidget {
    Q_OBJECT

public:
    explicit EventBoard(ExerciseRun& run, QWidget* parent = nullptr);
    void refresh(const core::Snapshot& now);

private:
    /// A fault of the own ship, as it is and as it was ordered while the order waits.
    struct FaultBox {
        QCheckBox* check;
        std::function<bool(const core::OwnShipView&)> is;
        std::int64_t orderedAt = -1;  ///< tick
    };
    void addEvents(QVBoxLayout& layout);
    void addFaults(QVBoxLayout& layout);
    void addFault(QVBoxLayout& layout, const QString& name, const QString& id, core::FaultOrder order,
                  std::function<bool(const core::OwnShipView&)> is);
    void addDifficulty(QVBoxLayout& layout);

    ExerciseRun& m_run;
    std::vector<QPushButton*> m_events;  ///< as World::events
    std::vector<FaultBox> m_faults;
    WeatherBox* m_weather;
    QComboBox* m_level = nullptr;
    std::size_t m_seen = 0;  ///< events of the run
    std::int64_t m_tick = 0;
};

}  // namespace sagara::ui
