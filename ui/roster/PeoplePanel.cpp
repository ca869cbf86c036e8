#include "ui/roster/PeoplePanel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSaveFile>
#include <QScrollArea>
#include <QShortcut>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/roster/ClassesDialog.h"
#include "ui/roster/Field.h"
#include "ui/roster/ImportDialog.h"
#include "ui/roster/PersonForm.h"
#include "ui/roster/RosterCsv.h"
#include "ui/roster/RosterTexts.h"
#include "ui/roster/Rows.h"

namespace sagara::ui::roster {
namespace {

constexpr int kForm_px = 340;
constexpr std::int64_t kAnyClass = -1;

QPushButton* button(const char* name, const QString& text, const QString& tip, QWidget* parent) {
    auto* const made = new QPushButton(text, parent);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    return made;
}

Row rowOf(const Person& p) {
    Row row{p.id, {p.name, p.number, p.rank, p.className, roleName(p.role), p.note}};
    if (p.retired) {
        for (Cell& cell : row.cells) cell.tone = Tone::Quiet;
        row.cells[4].text = PeoplePanel::tr("retired");
    }
    row.cells.back().tip = p.note;
    return row;
}

}  // namespace

PeoplePanel::PeoplePanel(RosterPort& port, QWidget* parent)
    : QWidget(parent),
      m_port(port),
      m_list(new QWidget(this)),
      m_table(new RowsView(QStringLiteral("people"),
                           {{tr("Name"), {}, false, true},
                            {tr("Number"), tr("Student or service number")},
                            {tr("Rank")},
                            {tr("Class")},
                            {tr("Role"), tr("Trainers and administrators may sign off assessments")},
                            {tr("Note"), {}, false, true}},
                           this)),
      m_form(new PersonForm(this)),
      m_search(new QLineEdit(this)),
      m_class(new QComboBox(this)),
      m_retired(new QCheckBox(tr("Retired too"), this)),
      m_count(hint({}, this)),
      m_add(button("person-add", tr("Add somebody"), tr("Ctrl+N"), this)),
      m_move(button("people-move", tr("Move to a class..."),
                    tr("Those selected; Ctrl or Shift selects several"), this)),
      m_classes(button("classes", tr("Classes..."), tr("Add, rename and retire classes"), this)),
      m_import(
          button("people-import", tr("Import..."), tr("People from a CSV file, looked through first"), this)),
      m_export(button("people-export", tr("Export..."), tr("The people shown here to a CSV file"), this)) {
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_search->setObjectName(QStringLiteral("people-search"));
    m_search->setPlaceholderText(tr("Search name, number, rank, class, note"));
    m_search->setClearButtonEnabled(true);
    m_search->setToolTip(tr("Words that all occur somewhere in the line (Ctrl+F)"));
    m_class->setObjectName(QStringLiteral("people-class"));
    m_class->setToolTip(tr("Shows one class only"));
    m_retired->setObjectName(QStringLiteral("people-retired"));
    m_retired->setToolTip(tr("Shows people who are no longer on the roster, too"));
    m_count->setWordWrap(false);
    m_count->setObjectName(QStringLiteral("people-count"));
    m_add->setProperty("primary", true);
    m_add->setShortcut(QKeySequence::New);

    auto* const finding = new QHBoxLayout;
    finding->addWidget(m_search, 1);
    finding->addWidget(m_class);
    finding->addWidget(m_retired);
    auto* const doing = new QHBoxLayout;
    doing->addWidget(m_add);
    doing->addWidget(m_move);
    doing->addWidget(m_classes);
    doing->addStretch(1);
    doing->addWidget(m_count);
    doing->addWidget(m_import);
    doing->addWidget(m_export);
    auto* const left = new QVBoxLayout(m_list);
    left->setContentsMargins(0, 0, 0, 0);
    left->addLayout(finding);
    left->addWidget(m_table, 1);
    left->addLayout(doing);
    auto* const scroll = new QScrollArea(this);
    scroll->setWidget(m_form);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFixedWidth(kForm_px);
    auto* const layout = new QHBoxLayout(this);
    layout->setSpacing(20);
    layout->addWidget(m_list, 1);
    layout->addWidget(scroll);

    auto* const find = new QShortcut(QKeySequence::Find, this);
    connect(find, &QShortcut::activated, m_search, qOverload<>(&QWidget::setFocus));
    connect(m_search, &QLineEdit::textChanged, this, [this](const QString& words) {
        m_table->setSearch(words);
        showPeople();
    });
    connect(m_class, &QComboBox::activated, this, &PeoplePanel::showPeople);
    connect(m_retired, &QCheckBox::toggled, this, &PeoplePanel::showPeople);
    connect(m_table, &RowsView::chosen, this, &PeoplePanel::showChosen);
    connect(m_add, &QPushButton::clicked, this, [this] {
        m_adding = true;
        m_list->setEnabled(false);
        m_form->startNew();
    });
    connect(m_form, &PersonForm::changedNow, this,
            [this](bool changed) { m_list->setEnabled(!changed && !m_adding); });
    connect(m_form, &PersonForm::cancelled, this, [this] {
        m_adding = false;
        showChosen();
        m_list->setEnabled(true);
        m_table->setFocus();
    });
    connect(m_form, &PersonForm::saveWanted, this, &PeoplePanel::save);
    connect(m_form, &PersonForm::retireWanted, this, &PeoplePanel::retire);
    connect(m_form, &PersonForm::assignWanted, this, &PeoplePanel::assignWanted);
    connect(m_form, &PersonForm::runsWanted, this, &PeoplePanel::runsWanted);
    connect(m_move, &QPushButton::clicked, this, &PeoplePanel::moveChosen);
    connect(m_classes, &QPushButton::clicked, this, [this] {
        auto* const dialog = new ClassesDialog(m_port, this);
        connect(dialog, &QDialog::finished, this, &PeoplePanel::changedRoster);
        dialog->open();
    });
    connect(m_import, &QPushButton::clicked, this, &PeoplePanel::askImport);
    connect(m_export, &QPushButton::clicked, this, &PeoplePanel::askExport);
}

bool PeoplePanel::changed() const { return m_form->changed(); }

void PeoplePanel::setColours(PaletteName palette) {
    m_palette = palette;
    m_table->setColours(palette);
}

void PeoplePanel::refresh() {
    m_people = m_port.people();
    const auto classes = m_port.classes();
    m_form->setKnown(m_people, classes);
    const auto before = m_class->currentData();
    m_class->clear();
    m_class->addItem(tr("All classes"), qlonglong(kAnyClass));
    m_class->addItem(tr("In no class"), qlonglong(0));
    for (const SchoolClass& c : classes)
        m_class->addItem(tr("%1 (%2)").arg(c.name).arg(c.people), qlonglong(c.id));
    m_class->setCurrentIndex(std::max(0, m_class->findData(before)));
    showPeople();
}

void PeoplePanel::showPeople() {
    std::vector<Row> rows;
    for (const Person& p : shown()) rows.push_back(rowOf(p));
    m_table->show(std::move(rows));
    const bool anybody =
        std::any_of(m_people.begin(), m_people.end(), [](const Person& p) { return !p.retired; });
    m_table->setEmptyText(
        !m_port.trouble().isEmpty() ? tr("The roster cannot be read just now.")
        : anybody                   ? tr("Nobody fits. Search for something else or show all classes.")
                  : tr("Nobody is on the roster yet. Add somebody, or import a list of names from a CSV file "
                       "that a spreadsheet has written."));
    m_count->setText(m_table->shownRows() == 1 ? tr("1 person") : tr("%1 people").arg(m_table->shownRows()));
    m_export->setEnabled(m_table->shownRows() > 0);
    showChosen();
}

void PeoplePanel::showChosen() {
    const auto ids = m_table->selectedIds();
    m_move->setEnabled(!ids.empty());
    if (m_adding) return;
    if (ids.size() > 1)
        return m_form->clear(
            tr("%1 people are selected. They can be moved to a class together.").arg(ids.size()));
    const Person* const person = ids.empty() ? nullptr : find(ids.front());
    if (person == nullptr)
        return m_form->clear(
            m_people.empty() ? QString() : tr("Select somebody in the list to see and change what is kept."));
    const Record record = m_port.recordOf(person->id);
    m_form->show(*person,
                 tr("%1 graded (%2 passed), %3 for practice")
                     .arg(record.grades == 1 ? tr("1 assessment") : tr("%1 assessments").arg(record.grades))
                     .arg(record.passedGrades)
                     .arg(record.practice == 1 ? tr("1 run") : tr("%1 runs").arg(record.practice)));
}

void PeoplePanel::save(const Person& person) {
    const auto saved = m_port.savePerson(person);
    if (!saved) return m_form->say(saved.error());
    m_adding = false;
    m_list->setEnabled(true);
    Q_EMIT changedRoster();
    m_table->select(*saved);
    showChosen();
    m_table->setFocus();
}

void PeoplePanel::retire(std::int64_t id, bool retired) {
    if (const Trouble trouble = m_port.retirePerson(id, retired)) return m_form->say(*trouble);
    Q_EMIT changedRoster();
}

void PeoplePanel::moveChosen() {
    auto* const dialog = new QInputDialog(this);
    dialog->setObjectName(QStringLiteral("move-dialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Move to a class"));
    dialog->setLabelText(tr("Class: choose one or type a new name (up to 80 characters). Empty: no class."));
    QStringList names{QString()};
    for (const SchoolClass& c : m_port.classes()) names.append(c.name);
    dialog->setComboBoxItems(names);
    dialog->setComboBoxEditable(true);
    connect(dialog, &QInputDialog::textValueSelected, this, [this](const QString& name) {
        if (const Trouble trouble = m_port.movePeople(m_table->selectedIds(), name.trimmed()))
            return tell(*trouble);
        Q_EMIT changedRoster();
    });
    dialog->open();
}

void PeoplePanel::askImport() {
    auto* const dialog = new QFileDialog(this, tr("Import people"));
    dialog->setObjectName(QStringLiteral("import-file"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Lists (*.csv *.tsv *.txt)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &PeoplePanel::importFrom);
    dialog->open();
}

void PeoplePanel::askExport() {
    auto* const dialog = new QFileDialog(this, tr("Export the people shown"));
    dialog->setObjectName(QStringLiteral("export-file"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilter(tr("CSV (*.csv)"));
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    dialog->selectFile(QStringLiteral("roster.csv"));
    connect(dialog, &QFileDialog::fileSelected, this, &PeoplePanel::exportTo);
    dialog->open();
}

void PeoplePanel::importFrom(const QString& name) {
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly))
        return tell(tr("%1 cannot be read: %2.").arg(name, file.errorString()));
    auto list = readCsv(file.readAll());
    if (!list) return tell(list.error());
    auto* const dialog = new ImportDialog(std::move(list).value(), m_port, this);
    dialog->setColours(m_palette);
    connect(dialog, &ImportDialog::imported, this, [this](int count) {
        Q_EMIT changedRoster();
        tell(count == 1 ? tr("1 person was added to the roster.")
                        : tr("%1 people were added to the roster.").arg(count),
             false);
    });
    dialog->open();
}

void PeoplePanel::exportTo(const QString& name) {
    std::vector<Person> people;
    for (const std::int64_t id : m_table->shownIds())
        if (const Person* const p = find(id)) people.push_back(*p);
    QSaveFile file(name);
    const QByteArray bytes = writeCsv(people);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit())
        return tell(tr("%1 cannot be written: %2.").arg(name, file.errorString()));
    tell(tr("%1 people are in %2.").arg(people.size()).arg(name), false);
}

void PeoplePanel::tell(const QString& text, bool trouble) {
    auto* const box = new QMessageBox(trouble ? QMessageBox::Warning : QMessageBox::Information, tr("Roster"),
                                      text, QMessageBox::Ok, this);
    box->setObjectName(QStringLiteral("roster-box"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
}

const Person* PeoplePanel::find(std::int64_t id) const {
    const auto known =
        std::find_if(m_people.begin(), m_people.end(), [id](const Person& p) { return p.id == id; });
    return known == m_people.end() ? nullptr : &*known;
}

std::vector<Person> PeoplePanel::shown() const {
    const std::int64_t wanted = m_class->currentIndex() < 0 ? kAnyClass : m_class->currentData().toLongLong();
    std::vector<Person> people;
    for (const Person& p : m_people) {
        const bool inClass = wanted == kAnyClass || p.classId == wanted;
        if (inClass && (m_retired->isChecked() || !p.retired)) people.push_back(p);
    }
    return people;
}

}  // namespace sagara::ui::roster
