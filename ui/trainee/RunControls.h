#pragma once

#include <QWidget>

#include "ui/run/ExerciseRun.h"

class QComboBox;
class QPushButton;

namespace sagara::ui::console {

/// Start, freeze, pace and end for who sails without a trainer.
class RunControls final : public QWidget {
    Q_OBJECT

public:
    explicit RunControls(ExerciseRun& run, QWidget* parent = nullptr);
    void refresh();

Q_SIGNALS:
    void endWanted();

private:
    ExerciseRun& m_run;
    QPushButton* m_start;
    QPushButton* m_end;
    QComboBox* m_rate;
};

}  // namespace sagara::ui::console
