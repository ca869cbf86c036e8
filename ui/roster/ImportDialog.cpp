#include "ui/roster/ImportDialog.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/roster/Field.h"
#include "ui/roster/Rows.h"

namespace sagara::ui::roster {
namespace {

enum Column { Line, Name, Number, Rank, Class, Note, Verdict, Why, ColumnCount };

QTableWidgetItem* item(const QString& text) {
    auto* const made = new QTableWidgetItem(text);
    made->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    made->setToolTip(text);
    return made;
}

QTableWidgetItem* verdictItem(const CsvRow& row) {
    const bool fault = !row.fault.isEmpty();
    auto* const made = item(fault                      ? ImportDialog::tr("fault")
                            : !row.duplicate.isEmpty() ? ImportDialog::tr("double")
                                                       : ImportDialog::tr("new"));
    const Tone tone = fault ? Tone::Bad : row.usable() ? Tone::Good : Tone::Attention;
    made->setData(RowsModel::kToneRole, static_cast<int>(tone));
    return made;
}

}  // namespace

ImportDialog::ImportDialog(CsvList list, RosterPort& port, QWidget* parent)
    : QDialog(parent),
      m_list(std::move(list)),
      m_port(port),
      m_table(new QTableWidget(this)),
      m_summary(hint({}, this)),
      m_trouble(new FieldNote(this)),
      m_import(new QPushButton(this)) {
    setObjectName(QStringLiteral("import-dialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Import people"));
    resize(1060, 560);
    markDuplicates(m_list.rows, m_port.people());
    m_summary->setObjectName(QStringLiteral("import-summary"));
    m_table->setObjectName(QStringLiteral("import-rows"));
    m_table->setColumnCount(ColumnCount);
    m_table->setHorizontalHeaderLabels({tr("Line"), tr("Name"), tr("Number"), tr("Rank"), tr("Class"),
                                        tr("Note"), tr("Line is"), tr("Why it stays out")});
    m_table->verticalHeader()->hide();
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setAlternatingRowColors(true);
    m_table->setShowGrid(false);
    m_table->setToolTip(tr("Space ticks and unticks the selected line"));
    m_import->setObjectName(QStringLiteral("import-now"));
    m_import->setProperty("primary", true);
    m_import->setToolTip(tr("Adds the ticked lines to the roster, all of them or none"));
    auto* const all = new QPushButton(tr("Tick all new ones"), this);
    all->setToolTip(tr("Lines with a fault and doubles stay out"));
    auto* const none = new QPushButton(tr("Untick all"), this);
    auto* const cancel = new QPushButton(tr("Cancel"), this);
    auto* const doing = new QHBoxLayout;
    doing->addWidget(all);
    doing->addWidget(none);
    doing->addStretch(1);
    doing->addWidget(cancel);
    doing->addWidget(m_import);
    auto* const layout = new QVBoxLayout(this);
    layout->addWidget(m_summary);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_trouble);
    layout->addLayout(doing);
    fill();
    connect(m_table, &QTableWidget::itemChanged, this, &ImportDialog::count);
    connect(all, &QPushButton::clicked, this, [this] { tickAll(true); });
    connect(none, &QPushButton::clicked, this, [this] { tickAll(false); });
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_import, &QPushButton::clicked, this, &ImportDialog::import);
    count();
}

void ImportDialog::setColours(PaletteName palette) {
    m_table->setItemDelegateForColumn(Verdict, toneDelegate(palette, m_table));
}

void ImportDialog::fill() {
    m_table->setRowCount(static_cast<int>(m_list.rows.size()));
    for (int r = 0; r < m_table->rowCount(); ++r) {
        const CsvRow& row = m_list.rows[static_cast<std::size_t>(r)];
        auto* const line = item(QString::number(row.line));
        line->setToolTip(tr("Line of the file"));
        if (row.usable()) {
            line->setFlags(line->flags() | Qt::ItemIsUserCheckable);
            line->setCheckState(Qt::Checked);
        }
        m_table->setItem(r, Line, line);
        m_table->setItem(r, Name, item(row.person.name));
        m_table->setItem(r, Number, item(row.person.number));
        m_table->setItem(r, Rank, item(row.person.rank));
        m_table->setItem(r, Class, item(row.person.className));
        m_table->setItem(r, Note, item(row.person.note));
        m_table->setItem(r, Verdict, verdictItem(row));
        m_table->setItem(r, Why, item(row.fault.isEmpty() ? row.duplicate : row.fault));
    }
    m_table->resizeColumnsToContents();
    for (int column = 0; column < Why; ++column)
        m_table->setColumnWidth(column, std::min(m_table->columnWidth(column) + 16, 200));
    m_table->horizontalHeader()->setSectionResizeMode(Why, QHeaderView::Stretch);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void ImportDialog::tickAll(bool on) {
    const QSignalBlocker quiet(m_table);
    for (int r = 0; r < m_table->rowCount(); ++r)
        if (m_list.rows[static_cast<std::size_t>(r)].usable())
            m_table->item(r, Line)->setCheckState(on ? Qt::Checked : Qt::Unchecked);
    count();
}

void ImportDialog::count() {
    const auto faults = std::count_if(m_list.rows.begin(), m_list.rows.end(),
                                      [](const CsvRow& row) { return !row.fault.isEmpty(); });
    const auto doubles = std::count_if(m_list.rows.begin(), m_list.rows.end(),
                                       [](const CsvRow& row) { return !row.duplicate.isEmpty(); });
    const auto chosen = ticked().size();
    QString text = tr("%1 lines: %2 new, %3 double, %4 with a fault. Untick what is not to be taken in.")
                       .arg(m_list.rows.size())
                       .arg(std::int64_t(m_list.rows.size()) - faults - doubles)
                       .arg(doubles)
                       .arg(faults);
    if (!m_list.ignored.isEmpty())
        text +=
            QLatin1Char(' ') + tr("Not used: the columns %1.").arg(m_list.ignored.join(QStringLiteral(", ")));
    m_summary->setText(text);
    m_import->setText(chosen == 1 ? tr("Import 1 person") : tr("Import %1 people").arg(chosen));
    m_import->setEnabled(chosen > 0);
}

void ImportDialog::import() {
    const std::vector<Person> people = ticked();
    if (const Trouble trouble = m_port.importPeople(people))
        return m_trouble->say(tr("Nobody was added: %1").arg(*trouble));
    accept();
    Q_EMIT imported(static_cast<int>(people.size()));
}

std::vector<Person> ImportDialog::ticked() const {
    std::vector<Person> people;
    for (int r = 0; r < m_table->rowCount(); ++r) {
        const CsvRow& row = m_list.rows[static_cast<std::size_t>(r)];
        if (row.usable() && m_table->item(r, Line)->checkState() == Qt::Checked) people.push_back(row.person);
    }
    return people;
}

}  // namespace sagara::ui::roster
