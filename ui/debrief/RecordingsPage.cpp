#include "ui/debrief/RecordingsPage.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>

#include "ui/run/RunTexts.h"

namespace sagara::ui {
namespace {

enum Column { Started, Scenario, Trainee, Type, Score, Length, State, Columns };

QString stateText(const RecordingEntry& entry) {
    if (!entry.present) return RecordingsPage::tr("file is missing");
    return entry.state;
}

QString scoreText(const RecordingEntry& entry) {
    if (!entry.score) return QStringLiteral("–");
    const QString score = QString::number(*entry.score, 'f', 0);
    return entry.passed ? RecordingsPage::tr("%1, passed").arg(score)
                        : RecordingsPage::tr("%1, not passed").arg(score);
}

bool matches(const RecordingEntry& entry, const QString& words) {
    const QString all = entry.scenario + QLatin1Char(' ') + entry.trainee + QLatin1Char(' ') + entry.type +
                        QLatin1Char(' ') + entry.started.toString(QStringLiteral("yyyy-MM-dd"));
    for (const QString& word : words.split(QLatin1Char(' '), Qt::SkipEmptyParts))
        if (!all.contains(word, Qt::CaseInsensitive)) return false;
    return true;
}

}  // namespace

RecordingsPage::RecordingsPage(RecordingsPorts ports, QWidget* parent)
    : Page(parent),
      m_ports(std::move(ports)),
      m_search(new QLineEdit(this)),
      m_table(new QTableWidget(0, Columns, this)),
      m_empty(new QLabel(this)),
      m_trouble(new QLabel(this)),
      m_open(new QPushButton(tr("Debrief"), this)) {
    setObjectName(QStringLiteral("recordings-page"));
    setWindowTitle(tr("Recordings"));
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(16, 12, 16, 12);
    layout->setSpacing(8);
    auto* const title = new QLabel(tr("Recordings"), this);
    QFont large = title->font();
    large.setPointSizeF(1.5 * large.pointSizeF());
    large.setBold(true);
    title->setFont(large);
    m_search->setObjectName(QStringLiteral("search-recordings"));
    m_search->setPlaceholderText(tr("Search: scenario, trainee, type or day, as 2027-01-15"));
    m_search->setToolTip(tr("Only runs with all of these words are listed"));
    m_search->setClearButtonEnabled(true);
    m_search->setMaximumWidth(460);
    auto* const top = new QHBoxLayout;
    top->addWidget(title);
    top->addStretch(1);
    top->addWidget(m_search, 2);
    layout->addLayout(top);
    m_trouble->setObjectName(QStringLiteral("trouble"));
    m_trouble->setWordWrap(true);
    m_trouble->hide();
    layout->addWidget(m_trouble);

    m_table->setObjectName(QStringLiteral("recordings"));
    m_table->setHorizontalHeaderLabels({tr("Started"), tr("Scenario"), tr("Trainee"), tr("Type"),
                                        tr("Score of 100"), tr("Length"), tr("State")});
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(Scenario, QHeaderView::Stretch);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->verticalHeader()->hide();
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setToolTip(
        tr("Enter or a double click opens the debriefing; scores are automatic and advisory"));
    layout->addWidget(m_table, 1);
    m_empty->setObjectName(QStringLiteral("empty"));
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    layout->addWidget(m_empty, 1);

    auto* const file = new QPushButton(tr("Open a file..."), this);
    file->setObjectName(QStringLiteral("open-file"));
    file->setToolTip(tr("A recording (.sgr) from elsewhere"));
    m_open->setObjectName(QStringLiteral("debrief"));
    m_open->setProperty("primary", true);
    m_open->setToolTip(tr("Replay the chosen run with its score, plots and what if"));
    auto* const bottom = new QHBoxLayout;
    bottom->addWidget(file);
    bottom->addStretch(1);
    bottom->addWidget(m_open);
    layout->addLayout(bottom);

    connect(m_search, &QLineEdit::textChanged, this, &RecordingsPage::fill);
    connect(m_table, &QTableWidget::cellActivated, this, &RecordingsPage::openCurrent);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, [this] {
        const int row = m_table->currentRow();
        m_open->setEnabled(row >= 0 && m_table->item(row, Started)->data(Qt::UserRole + 1).toBool());
    });
    connect(m_open, &QPushButton::clicked, this, &RecordingsPage::openCurrent);
    connect(file, &QPushButton::clicked, this, &RecordingsPage::chooseFile);
    refresh();
}

void RecordingsPage::showEvent(QShowEvent* event) {
    Page::showEvent(event);
    refresh();
}

void RecordingsPage::refresh() {
    m_entries = m_ports.list();
    tell(m_ports.trouble);
    fill();
}

void RecordingsPage::tell(const QString& words) {
    m_trouble->setText(words);
    m_trouble->setVisible(!words.isEmpty());
}

void RecordingsPage::fill() {
    m_table->setRowCount(0);
    for (const RecordingEntry& entry : m_entries) {
        if (!matches(entry, m_search->text())) continue;
        const int row = m_table->rowCount();
        m_table->insertRow(row);
        const QString texts[Columns] = {
            entry.started.toLocalTime().toString(QStringLiteral("yyyy-MM-dd  HH:mm")),
            entry.scenario,
            entry.trainee.isEmpty() ? tr("nobody named") : entry.trainee,
            entry.type,
            scoreText(entry),
            elapsed({std::llround(1e6 * entry.length_s)}),
            stateText(entry)};
        for (int column = 0; column < Columns; ++column) {
            auto* const item = new QTableWidgetItem(texts[column]);
            if (column == Score || column == Length)
                item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            if (!entry.present) item->setForeground(palette().color(QPalette::Disabled, QPalette::Text));
            item->setToolTip(entry.file);
            m_table->setItem(row, column, item);
        }
        m_table->item(row, Started)->setData(Qt::UserRole, entry.file);
        m_table->item(row, Started)->setData(Qt::UserRole + 1, entry.present);
    }
    const bool none = m_table->rowCount() == 0;
    m_table->setVisible(!none);
    m_empty->setVisible(none);
    m_empty->setText(
        m_entries.empty()
            ? tr("No run has been recorded here yet.\nSail one from Teach, Train or Practise: it "
                 "is recorded by itself. Or open a recording from elsewhere below.")
            : tr("No run has all of these words. Clear the search to see all %1 runs.")
                  .arg(m_entries.size()));
    if (!none) m_table->selectRow(0);
    m_open->setEnabled(!none && m_table->item(0, Started)->data(Qt::UserRole + 1).toBool());
}

void RecordingsPage::openCurrent() {
    const int row = m_table->currentRow();
    if (row < 0 || !m_open->isEnabled()) return;
    openFile(m_table->item(row, Started)->data(Qt::UserRole).toString());
}

void RecordingsPage::chooseFile() {
    auto* const dialog = new QFileDialog(this, tr("Open a recording"), m_ports.folder,
                                         tr("Sagara recordings (*.sgr);;All files (*)"));
    dialog->setObjectName(QStringLiteral("file-dialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    connect(dialog, &QFileDialog::fileSelected, this, &RecordingsPage::openFile);
    dialog->open();
}

void RecordingsPage::openFile(const QString& file) {
    const auto trouble = m_ports.open(file);
    tell(trouble ? *trouble : m_ports.trouble);
}

}  // namespace sagara::ui
