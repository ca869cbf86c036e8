#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/editor/DryRun.h"
#include "ui/editor/EditorContext.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace sagara::ui::editor {

/// VIEW: has the pilot sail the draft, and shows what came of it.
class DryRunPanel final : public QWidget {
    Q_OBJECT
public:
    DryRunPanel(EditorContext& context, QWidget* parent);

    const DryRun& run() const { return m_run; }

Q_SIGNALS:
    /// A track is there, or there is none any more.
    void trackChanged();
    void problemsFound();
    void placeChosen(core::NorthEast place);

private:
    void start();
    void tick();
    void finish();
    void showResult(const DryRunResult& result);

    EditorContext& m_context;
    DryRun m_run;
    QTimer m_beat;
    std::shared_ptr<const Json> m_sailed;
    QComboBox* m_level;
    QPushButton* m_start;
    QPushButton* m_cancel;
    QProgressBar* m_progress;
    QLabel* m_now;
    QLabel* m_result;
    QLabel* m_old;
    QTableWidget* m_tasks;
    QTableWidget* m_losses;
};

}  // namespace sagara::ui::editor
