#pragma once

#include <QDialog>

#include "ui/roster/RosterPort.h"

class QLineEdit;
class QPushButton;

namespace sagara::ui::roster {

class FieldNote;
class RowsView;

/// The classes of the school: added, renamed, retired. Who is in them is set in the list of people.
class ClassesDialog final : public QDialog {
    Q_OBJECT

public:
    ClassesDialog(RosterPort& port, QWidget* parent = nullptr);

private:
    void refresh();
    void check();
    void done(const Trouble& trouble);
    using QDialog::done;

    RosterPort& m_port;
    std::vector<SchoolClass> m_classes;
    RowsView* m_table;
    QLineEdit* m_name;
    FieldNote* m_note;
    QPushButton *m_add, *m_rename, *m_retire;
};

}  // namespace sagara::ui::roster
