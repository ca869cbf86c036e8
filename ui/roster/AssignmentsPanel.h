#pragma once

#include <QWidget>

#include "ui/roster/RosterPort.h"
#include "ui/theme/PaletteName.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace sagara::ui::roster {

class AssignmentForm;
class FieldNote;
class RowsView;

/// Missions that were given: to whom, by when, who has sailed them.
class AssignmentsPanel final : public QWidget {
    Q_OBJECT

public:
    AssignmentsPanel(RosterPort& port, QWidget* parent = nullptr);

    void refresh();
    void setColours(PaletteName palette);
    void assignTo(std::int64_t person);

private:
    void showAssignments();
    void showMembers();
    const Assignment* chosen() const;

    RosterPort& m_port;
    std::vector<Assignment> m_assignments;
    QComboBox* m_state;
    RowsView *m_table, *m_members;
    QLabel* m_membersTitle;
    FieldNote* m_trouble;
    QPushButton* m_withdraw;
    AssignmentForm* m_form;
};

}  // namespace sagara::ui::roster
