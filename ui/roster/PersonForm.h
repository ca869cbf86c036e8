#pragma once

#include <QWidget>

#include "ui/roster/RosterTypes.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace sagara::ui::roster {

class FieldNote;

/// One person: looked at, changed or added. Checks what is typed as it is typed.
class PersonForm final : public QWidget {
    Q_OBJECT

public:
    explicit PersonForm(QWidget* parent = nullptr);

    /// Who must not have the same name or number, and the classes to choose from.
    void setKnown(std::vector<Person> people, const std::vector<SchoolClass>& classes);
    void show(const Person& person, const QString& record);
    void startNew();
    void clear(const QString& instead);  ///< nobody; says why
    bool changed() const { return m_changed; }
    void say(const QString& trouble);
    using QWidget::show;

Q_SIGNALS:
    void saveWanted(const Person& person);
    void cancelled();
    void changedNow(bool changed);
    void retireWanted(std::int64_t id, bool retired);
    void assignWanted(std::int64_t id);
    void runsWanted(std::int64_t id);

private:
    void fill(const Person& person);
    Person typed() const;
    void check();
    QString takenFault(const QString& value, QString Person::*member) const;

    std::vector<Person> m_people;
    Person m_person;
    bool m_changed = false;
    bool m_filling = false;
    QWidget* m_fields;
    QLabel* m_instead;
    QLabel* m_title;
    QLabel* m_record;
    QLineEdit *m_name, *m_number, *m_rank, *m_note;
    FieldNote *m_nameNote, *m_numberNote, *m_rankNote, *m_classNote, *m_noteNote, *m_trouble;
    QComboBox *m_class, *m_role;
    QPushButton *m_save, *m_cancel, *m_retire, *m_assign, *m_runs;
};

}  // namespace sagara::ui::roster
