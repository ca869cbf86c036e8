#include "ui/practise/PersonPanel.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

namespace sagara::ui {
namespace {

QTableWidget* table(const char* name, const QStringList& heads, QWidget* parent) {
    auto* const made = new QTableWidget(0, static_cast<int>(heads.size()), parent);
    made->setObjectName(QString::fromLatin1(name));
    made->setHorizontalHeaderLabels(heads);
    made->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    made->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    made->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    made->verticalHeader()->hide();
    made->setEditTriggers(QAbstractItemView::NoEditTriggers);
    made->setSelectionBehavior(QAbstractItemView::SelectRows);
    made->setSelectionMode(QAbstractItemView::SingleSelection);
    made->setShowGrid(false);
    made->setTabKeyNavigation(false);
    return made;
}

QLabel* heading(const QString& text, QWidget* parent) {
    auto* const label = new QLabel(text, parent);
    QFont font = label->font();
    font.setBold(true);
    label->setFont(font);
    return label;
}

void put(QTableWidget* table, int row, const QStringList& cells, const QString& tip) {
    for (int column = 0; column < cells.size(); ++column) {
        auto* const item = new QTableWidgetItem(cells[column]);
        item->setToolTip(tip);
        table->setItem(row, column, item);
    }
}

}  // namespace

PersonPanel::PersonPanel(const PractisePorts& ports, QWidget* parent)
    : QWidget(parent),
      m_ports(ports),
      m_name(new QComboBox(this)),
      m_note(new QLabel(this)),
      m_assignments(table("assignments", {tr("Mission"), tr("Due")}, this)),
      m_noAssignments(new QLabel(this)),
      m_runs(table("runs", {tr("Sailed"), tr("On"), tr("Score")}, this)),
      m_noRuns(new QLabel(this)) {
    m_name->setObjectName(QStringLiteral("person"));
    m_name->setEditable(true);
    m_name->setInsertPolicy(QComboBox::NoInsert);
    m_name->addItem(QString());
    for (const std::string& person : ports.people) m_name->addItem(QString::fromStdString(person));
    m_name->lineEdit()->setPlaceholderText(tr("Your name, or empty for nobody"));
    m_name->lineEdit()->setMaxLength(80);
    m_name->setToolTip(tr("Choose or type your name, up to 80 characters; a new one is added to the roster"));
    m_name->setAccessibleName(tr("Your name"));
    m_note->setObjectName(QStringLiteral("person-note"));
    for (QLabel* label : {m_note, m_noAssignments, m_noRuns}) label->setWordWrap(true);

    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(heading(tr("Who you are"), this));
    layout->addWidget(m_name);
    layout->addWidget(m_note);
    layout->addSpacing(6);
    layout->addWidget(heading(tr("Assigned to you"), this));
    layout->addWidget(m_noAssignments);
    layout->addWidget(m_assignments, 2);
    layout->addSpacing(6);
    layout->addWidget(heading(tr("Your runs"), this));
    layout->addWidget(m_noRuns);
    layout->addWidget(m_runs, 3);
    layout->addStretch(1);

    auto* const typed = new QTimer(this);  // no look into the database at every letter
    typed->setSingleShot(true);
    typed->setInterval(250);
    connect(typed, &QTimer::timeout, this, &PersonPanel::look);
    connect(m_name, &QComboBox::editTextChanged, typed, [typed] { typed->start(); });
    connect(m_assignments, &QTableWidget::currentCellChanged, this, [this](int row) {
        if (row < 0 || row >= static_cast<int>(m_given.size())) return;
        const PractiseAssignment& given = m_given[static_cast<std::size_t>(row)];
        Q_EMIT assignmentChosen(QString::fromStdString(given.scenario), given.level);
    });
    look();
}

std::string PersonPanel::person() const { return m_name->currentText().trimmed().toStdString(); }

QString PersonPanel::problem() const { return person().empty() ? QString() : m_ports.nameProblem(person()); }

QString PersonPanel::bestOf(const std::string& scenario) const {
    const PastRun* best = nullptr;
    for (const PastRun& run : m_past)
        if (run.graded && run.scenario == scenario && (best == nullptr || run.score > best->score))
            best = &run;
    if (best == nullptr) return {};
    return tr("Your best here: %1 of 100 at level %2, %3, %4")
        .arg(best->score, 0, 'f', 0)
        .arg(best->level)
        .arg(best->passed ? tr("passed") : tr("not passed"), best->when);
}

void PersonPanel::refresh() { look(); }

void PersonPanel::look() {
    const std::string who = person();
    const QString wrong = problem();
    const bool known = std::find(m_ports.people.begin(), m_ports.people.end(), who) != m_ports.people.end();
    m_note->setText(!wrong.isEmpty() ? wrong
                    : who.empty()    ? tr("The run is kept without a name.")
                    : known          ? tr("The run is kept under your name.")
                                     : tr("A new name: it is added to the roster when you set sail."));
    const bool named = !who.empty() && wrong.isEmpty();
    m_given = named ? m_ports.assignments(who) : std::vector<PractiseAssignment>{};
    m_past = named ? m_ports.history(who) : std::vector<PastRun>{};
    const QSignalBlocker quiet(m_assignments);
    m_assignments->setRowCount(static_cast<int>(m_given.size()));
    for (int row = 0; row < m_assignments->rowCount(); ++row) {
        const PractiseAssignment& a = m_given[static_cast<std::size_t>(row)];
        put(m_assignments, row, {a.name, a.late ? tr("%1, late").arg(a.due) : a.due},
            a.alone ? tr("Level %1 or harder; sailing it here fulfils it").arg(a.level)
                    : tr("Level %1 or harder, with your trainer; here you can practise it").arg(a.level));
    }
    m_runs->setRowCount(static_cast<int>(m_past.size()));
    for (int row = 0; row < m_runs->rowCount(); ++row) {
        const PastRun& run = m_past[static_cast<std::size_t>(row)];
        const QString score =
            !run.graded ? tr("none")
                        : tr("%1 %2").arg(run.score, 0, 'f', 0).arg(run.passed ? tr("✓") : QString());
        put(m_runs, row, {run.name, run.when, score.trimmed()},
            tr("%1, %2, level %3%4")
                .arg(run.name, run.type)
                .arg(run.level)
                .arg(run.graded && run.passed ? tr(", passed") : QString()));
    }
    m_assignments->setVisible(!m_given.empty());
    m_noAssignments->setVisible(m_given.empty());
    m_noAssignments->setText(named ? tr("Nothing. Choose what you like.") : tr("Give your name to see it."));
    m_runs->setVisible(!m_past.empty());
    m_noRuns->setVisible(m_past.empty());
    m_noRuns->setText(named ? tr("None yet.") : tr("Give your name to see them."));
    Q_EMIT changed();
}

}  // namespace sagara::ui
