#pragma once

#include <QWidget>

#include "ui/roster/RosterPort.h"
#include "ui/theme/PaletteName.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace sagara::ui::roster {

class FieldNote;
class RowsView;

/// Every run that was sailed here, with its result; from here to its result page, debriefing and report.
class HistoryPanel final : public QWidget {
    Q_OBJECT

public:
    HistoryPanel(RosterPort& port, QWidget* parent = nullptr);

    void refresh();
    void setColours(PaletteName palette);
    void showRunsOf(std::int64_t person);

private:
    void showRuns();
    void showButtons();
    void report();
    RunFilter filter() const;
    void say(const Trouble& trouble);

    RosterPort& m_port;
    std::vector<Run> m_runs;
    int m_most;
    QComboBox *m_person, *m_class, *m_mission, *m_type;
    RowsView* m_table;
    QLabel* m_summary;
    FieldNote* m_trouble;
    QPushButton *m_more, *m_result, *m_debrief, *m_report, *m_all;
};

}  // namespace sagara::ui::roster
