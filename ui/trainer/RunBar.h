#pragma once

#include <QWidget>

#include "ui/run/ExerciseRun.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace sagara::ui {

/// Start, freeze, pace and end of a run, and its clocks.
class RunBar final : public QWidget {
    Q_OBJECT

public:
    explicit RunBar(ExerciseRun& run, QWidget* parent = nullptr);
    void refresh();
    /// An assessment never goes back.
    void setMayGoBack(bool may);

Q_SIGNALS:
    /// To a whole second that has been sailed.
    void goBackWanted(std::int64_t second);
    /// The trainee's console in a window of its own.
    void consoleWanted();
    /// The trainer wants the run to end and be graded; whoever owns it asks once more and does it.
    void endWanted();

private:
    void toggle();
    void fillGoBack();
    void askSecond();
    std::int64_t sailed_s() const;

    ExerciseRun& m_run;
    QPushButton* m_start;
    QPushButton* m_goBack;
    QPushButton* m_end;
    QComboBox* m_rate;
    QLabel* m_clock;
    QLabel* m_state;
};

}  // namespace sagara::ui
