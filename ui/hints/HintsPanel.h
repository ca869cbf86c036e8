#pragma once

#include <QWidget>

#include "ui/hints/HintTexts.h"
#include "ui/run/ExerciseRun.h"
#include "ui/theme/PaletteName.h"

class QLabel;
class QVBoxLayout;

namespace sagara::ui {

/// Hints of a mission for who sails alone, with the score as it stands. Looks at the run twice a second while
/// it is on the screen. The run outlives it.
class HintsPanel final : public QWidget {
    Q_OBJECT

public:
    explicit HintsPanel(ExerciseRun& run, QWidget* parent = nullptr);
    void refresh();
    void setColours(PaletteName palette);

private:
    struct Row {
        QLabel* name;
        QLabel* value;
        QLabel* detail;
    };
    Row& row(int index);
    void showLine(int index, const HintLine& line);
    void showLosses();

    ExerciseRun& m_run;
    PaletteName m_palette = PaletteName::Day;
    QVBoxLayout* m_lines;
    std::vector<Row> m_rows;
    QLabel* m_score;
    QLabel* m_losses;
    std::size_t m_eventsSeen = 0;
    QStringList m_lossLines;
};

}  // namespace sagara::ui
