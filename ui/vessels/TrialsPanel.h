#pragma once

#include <QFutureWatcher>
#include <QWidget>
#include <atomic>
#include <memory>
#include <optional>

#include "core/identify/StandardTrials.h"
#include "core/vessel/Vessel.h"
#include "ui/theme/PaletteName.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace sagara::ui {

class PlotView;

/// Runs the standard trials of a vessel aside and shows them against the IMO standards.
class TrialsPanel final : public QWidget {
    Q_OBJECT

public:
    explicit TrialsPanel(QWidget* parent = nullptr);
    ~TrialsPanel() override;

    /// Another vessel: a run that is on is cancelled and what was shown goes.
    void setVessel(std::optional<core::Vessel> vessel);
    void setColours(PaletteName name);
    void start();
    void cancel();
    bool running() const;
    /// Of this vessel, if they have been run.
    const std::optional<core::StandardTrials>& trials() const { return m_trials; }

Q_SIGNALS:
    void finished();

private:
    struct Progress {
        std::atomic<bool> cancelled{false};
        std::atomic<int> permille{0};
    };
    void showTrials();
    void showState();
    void saveCsv();

    std::optional<core::Vessel> m_vessel;
    std::optional<core::StandardTrials> m_trials;
    QFutureWatcher<core::StandardTrials> m_watcher;
    std::shared_ptr<Progress> m_progress;
    QPushButton *m_run, *m_cancel, *m_csv;
    QProgressBar* m_bar;
    QLabel* m_note;
    QTableWidget* m_checks;
    PlotView *m_turning, *m_time, *m_zigzag10, *m_zigzag20, *m_stopping;
    QTimer* m_timer;
    PaletteName m_colours = PaletteName::Day;
};

}  // namespace sagara::ui
