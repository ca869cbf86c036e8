#pragma once

#include <QWidget>

#include "ui/debrief/Marks.h"
#include "ui/theme/PaletteName.h"

class QLabel;
class QTreeWidget;

namespace sagara::ui {

/// What became of the run: result, tasks with their times, deductions with what they cost. A click on a line
/// goes to its moment.
class ScorePanel final : public QWidget {
    Q_OBJECT

public:
    explicit ScorePanel(QWidget* parent = nullptr);

    void setColours(PaletteName name);
    void setResult(const ReplayResult& result);
    void setNotes(const std::vector<DebriefMark>& marks);
    /// What had come by then stands out; the rest is quiet.
    void setNow(core::SimTime time);

Q_SIGNALS:
    void picked(core::SimTime time);

private:
    void fill();

    PaletteName m_colours = PaletteName::Day;
    ReplayResult m_result;
    std::vector<DebriefMark> m_notes;
    core::SimTime m_now;
    QLabel* m_score;
    QLabel* m_verdict;
    QLabel* m_advisory;
    QTreeWidget* m_list;
};

}  // namespace sagara::ui
