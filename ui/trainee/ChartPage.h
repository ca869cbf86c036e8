#pragma once

#include <QWidget>
#include <memory>

#include "ui/run/ExerciseRun.h"
#include "ui/theme/PaletteName.h"
#include "ui/trainee/Bearings.h"
#include "ui/trainee/ConsoleOptions.h"

class QAction;
class QToolBar;

namespace sagara::ui {
class ChartWidget;
}  // namespace sagara::ui

namespace sagara::ui::console {

/// The trainee's chart: area, route, own ship with her track, ships that send AIS, lines of position. Knows
/// no more of the exercise than that.
class ChartPage final : public QWidget {
    Q_OBJECT

public:
    ChartPage(ExerciseRun& run, const ConsoleOptions& options, QWidget* parent = nullptr);
    void setColours(PaletteName name);
    void show(const core::Snapshot& now);
    using QWidget::show;
    void setBearings(const std::vector<Bearing>& bearings) { m_overlay->setBearings(bearings); }
    ChartWidget& chart() { return *m_chart; }

public Q_SLOTS:
    /// Asks where to: a printer or a PDF.
    void print();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void addTools(QToolBar& bar);
    void predict();

    ExerciseRun& m_run;
    std::size_t m_ship;
    bool m_prediction;
    std::shared_ptr<const PreparedChart> m_prepared;
    ChartWidget* m_chart;
    BearingOverlay* m_overlay;
    bool m_laidOut = false;
    std::int64_t m_trackedTo_s = -1;
    std::int64_t m_predictedAt_s = -10;
};

}  // namespace sagara::ui::console
