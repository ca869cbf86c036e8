#pragma once

#include <QWidget>

#include "ui/practise/PractisePorts.h"

class QComboBox;
class QLabel;
class QTableWidget;

namespace sagara::ui {

/// Who sails, what they have been given, and what they have sailed.
class PersonPanel final : public QWidget {
    Q_OBJECT

public:
    explicit PersonPanel(const PractisePorts& ports, QWidget* parent = nullptr);

    std::string person() const;  ///< empty: nobody named
    QString problem() const;     ///< of the name; empty when it can be one
    /// "Your best here: 92 of 100, passed"; empty without a graded run of it.
    QString bestOf(const std::string& scenario) const;
    void refresh();  ///< after a run

Q_SIGNALS:
    void changed();
    void assignmentChosen(const QString& scenario, int level);

private:
    void look();

    const PractisePorts& m_ports;
    std::vector<PractiseAssignment> m_given;
    std::vector<PastRun> m_past;
    QComboBox* m_name;
    QLabel* m_note;
    QTableWidget* m_assignments;
    QLabel* m_noAssignments;
    QTableWidget* m_runs;
    QLabel* m_noRuns;
};

}  // namespace sagara::ui
