#pragma once

#include <QWidget>

#include "ui/roster/RosterPort.h"
#include "ui/theme/PaletteName.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace sagara::ui::roster {

class PersonForm;
class RowsView;

/// The people of the school: found, added, changed, retired, put into classes, read from and written to a
/// file.
class PeoplePanel final : public QWidget {
    Q_OBJECT

public:
    PeoplePanel(RosterPort& port, QWidget* parent = nullptr);

    void refresh();
    void setColours(PaletteName palette);
    bool changed() const;  ///< typed and not saved
    /// Shows what a file holds and takes in what is chosen there.
    void importFrom(const QString& file);
    void exportTo(const QString& file);

Q_SIGNALS:
    void changedRoster();
    void assignWanted(std::int64_t person);
    void runsWanted(std::int64_t person);

private:
    void showPeople();
    void showChosen();
    void save(const Person& person);
    void retire(std::int64_t id, bool retired);
    void moveChosen();
    void askImport();
    void askExport();
    void tell(const QString& text, bool trouble = true);
    const Person* find(std::int64_t id) const;
    std::vector<Person> shown() const;

    RosterPort& m_port;
    std::vector<Person> m_people;
    bool m_adding = false;
    PaletteName m_palette = PaletteName::Day;
    QWidget* m_list;
    RowsView* m_table;
    PersonForm* m_form;
    QLineEdit* m_search;
    QComboBox* m_class;
    QCheckBox* m_retired;
    QLabel* m_count;
    QPushButton *m_add, *m_move, *m_classes, *m_import, *m_export;
};

}  // namespace sagara::ui::roster
