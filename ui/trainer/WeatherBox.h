#pragma once

#include <QGroupBox>
#include <functional>
#include <vector>

#include "ui/run/ExerciseRun.h"

class QDoubleSpinBox;
class QGridLayout;
class QPushButton;

namespace sagara::ui {

/// The weather as it is, and as it is to be: what the trainer touches is ordered, within the time he gives;
/// the rest stays and goes on showing what is.
class WeatherBox final : public QGroupBox {
    Q_OBJECT

public:
    explicit WeatherBox(ExerciseRun& run, QWidget* parent = nullptr);
    void refresh(const core::Snapshot& now);

private:
    /// One figure: what it is now, in its unit.
    struct Field {
        QDoubleSpinBox* spin;
        std::function<double(const core::Weather&)> now;
        bool touched = false;
    };
    enum Name : std::size_t { Wind, WindFrom, Gusts, Visibility, Rain, Current, CurrentTo, Swell1 };
    static constexpr std::size_t kPerSwell = 3;  ///< height, period, from

    void add(const QString& id, double most, int decimals, const QString& unit, const QString& tip,
             std::function<double(const core::Weather&)> now, double least = 0.0);
    void place(QGridLayout& grid, const QString& name, std::initializer_list<std::size_t> fields);
    bool any() const;
    bool touched(std::size_t first, std::size_t count) const;
    double value(std::size_t field) const;
    core::WeatherOrder order() const;
    void apply();

    ExerciseRun& m_run;
    std::vector<Field> m_fields;
    QDoubleSpinBox* m_ramp;
    QPushButton* m_apply;
    std::int64_t m_orderedAt = -1;  ///< tick
};

}  // namespace sagara::ui
