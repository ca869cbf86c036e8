#pragma once

#include <QDialog>

#include "ui/roster/RosterCsv.h"
#include "ui/roster/RosterPort.h"
#include "ui/theme/PaletteName.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace sagara::ui::roster {

class FieldNote;

/// What a file of people holds, line by line, before any of it is kept. Only lines that are ticked are taken
/// in, all of them or none; a line with a fault or a double cannot be ticked.
class ImportDialog final : public QDialog {
    Q_OBJECT

public:
    ImportDialog(CsvList list, RosterPort& port, QWidget* parent = nullptr);
    void setColours(PaletteName palette);

Q_SIGNALS:
    void imported(int count);

private:
    void fill();
    void tickAll(bool on);
    void count();
    void import();
    std::vector<Person> ticked() const;

    CsvList m_list;
    RosterPort& m_port;
    QTableWidget* m_table;
    QLabel* m_summary;
    FieldNote* m_trouble;
    QPushButton* m_import;
};

}  // namespace sagara::ui::roster
