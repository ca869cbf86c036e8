#pragma once

#include <QWidget>

#include "ui/roster/RosterPort.h"

class QComboBox;
class QDateTimeEdit;
class QPushButton;

namespace sagara::ui::roster {

class FieldNote;

/// A mission for a person or a class: which, by when, as what, how hard.
class AssignmentForm final : public QWidget {
    Q_OBJECT

public:
    explicit AssignmentForm(QWidget* parent = nullptr);

    void setChoices(const std::vector<Person>& people, const std::vector<SchoolClass>& classes,
                    const std::vector<Mission>& missions, core::Utc now);
    void choosePerson(std::int64_t id);
    void say(const QString& trouble);

Q_SIGNALS:
    void assignWanted(const NewAssignment& assignment);

private:
    void check();
    NewAssignment typed() const;

    core::Utc m_now;
    QComboBox *m_mission, *m_whom, *m_type, *m_level, *m_by;
    QDateTimeEdit* m_due;
    FieldNote *m_missionNote, *m_whomNote, *m_dueNote, *m_trouble;
    QPushButton* m_assign;
};

}  // namespace sagara::ui::roster
