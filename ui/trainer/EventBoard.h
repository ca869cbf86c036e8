#pragma once

#include <QWidget>

#include "ui/run/ExerciseRun.h"

class QDoubleSpinBox;
class QVBoxLayout;

namespace sagara::ui {

/// What the trainer does to the exercise: events of the scenario, faults, weather, difficulty. Every control
/// gives an order and nothing else.
class EventBoard final : public QWidget {
    Q_OBJECT

public:
    explicit EventBoard(ExerciseRun& run, QWidget* parent = nullptr);

private:
    void addEvents(QVBoxLayout& layout);
    void addFaults(QVBoxLayout& layout);
    void addWeather(QVBoxLayout& layout);
    void addDifficulty(QVBoxLayout& layout);
    QDoubleSpinBox* spin(double least, double most, double value, int decimals, const QString& unit);

    ExerciseRun& m_run;
};

}  // namespace sagara::ui
