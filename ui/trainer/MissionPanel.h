#pragma once

#include <QWidget>

#include "ui/run/ExerciseRun.h"

class QLabel;
class QListWidget;

namespace sagara::ui {

/// Tasks with what is done, the score as it stands, and the log of what happened.
class MissionPanel final : public QWidget {
    Q_OBJECT

public:
    explicit MissionPanel(ExerciseRun& run, QWidget* parent = nullptr);
    void refresh();

private:
    ExerciseRun& m_run;
    QLabel* m_score;
    QListWidget* m_tasks;
    QListWidget* m_log;
    std::size_t m_events = 0;
    std::int64_t m_seen = 0;  ///< tick
};

}  // namespace sagara::ui
