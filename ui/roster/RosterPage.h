#pragma once

#include <memory>

#include "ui/roster/RosterPort.h"
#include "ui/theme/Page.h"

class QLabel;
class QTabWidget;

namespace sagara::ui::roster {

class AssignmentsPanel;
class HistoryPanel;
class PeoplePanel;

/// The school's roster: people, the missions they were given, and what they have sailed.
class RosterPage final : public Page {
    Q_OBJECT

public:
    explicit RosterPage(std::unique_ptr<RosterPort> port, QWidget* parent = nullptr);

    void setColours(PaletteName palette) override;
    bool mayLeave() override;
    QString helpTopic() const override { return QStringLiteral("roster"); }
    void refresh();

protected:
    void showEvent(QShowEvent* event) override;  ///< reads again: something may have been sailed meanwhile

private:
    std::unique_ptr<RosterPort> m_port;
    QLabel* m_trouble;
    QTabWidget* m_tabs;
    PeoplePanel* m_people;
    AssignmentsPanel* m_assignments;
    HistoryPanel* m_history;
};

}  // namespace sagara::ui::roster
