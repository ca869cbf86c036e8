#pragma once

#include <QWidget>
#include <array>
#include <memory>

#include "ui/run/ExerciseRun.h"
#include "ui/theme/PaletteName.h"
#include "ui/trainer/TraceSeries.h"
#include "ui/widgets/ChartScene.h"

class QPushButton;

namespace sagara::ui {

class PlanView;
class TraceBoard;

/// For the classroom: which motions are free, the plan with the forces, and the traces of the motions.
class ClassroomPanel final : public QWidget {
    Q_OBJECT

public:
    ClassroomPanel(ExerciseRun& run, std::uint8_t ship, QWidget* parent = nullptr);
    ~ClassroomPanel() override;
    void setColours(PaletteName name);
    /// `forces` on the ship now, or none.
    void refresh(const core::Snapshot& now, const std::vector<ShownForce>& forces);
    const TraceSeries& series() const { return m_series; }

private:
    void order(std::uint8_t free);
    QWidget* motionButtons();

    ExerciseRun& m_run;
    std::uint8_t m_ship;
    std::array<QPushButton*, 6> m_motions{};
    QPushButton* m_all = nullptr;
    PlanView* m_plan;
    TraceBoard* m_traces;
    TraceSeries m_series;
    std::int64_t m_orderedAt = -1;  ///< tick; until it is past, the buttons show what was ordered
};

}  // namespace sagara::ui
