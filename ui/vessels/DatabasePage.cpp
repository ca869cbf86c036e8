#include "ui/vessels/DatabasePage.h"

#include <QDate>
#include <QFileDialog>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <QtConcurrent>

#include "ui/theme/Theme.h"
#include "ui/theme/ThemeColours.h"

namespace sagara::ui {
namespace {

QString q(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

QString joined(const std::vector<std::string>& lines) {
    QStringList list;
    for (const std::string& line : lines) list += QString::fromStdString(line);
    return list.join(QLatin1Char('\n'));
}

}  // namespace

DatabasePage::DatabasePage(DatabaseCare& care, QWidget* parent)
    : Page(parent),
      m_care(care),
      m_file(new QLabel(this)),
      m_size(new QLabel(this)),
      m_version(new QLabel(this)),
      m_state(new QLabel(this)),
      m_rows(new QTableWidget(0, 2, this)),
      m_check(new QPushButton(tr("Check integrity"), this)),
      m_backup(new QPushButton(tr("Back up…"), this)),
      m_restore(new QPushButton(tr("Restore…"), this)),
      m_bar(new QProgressBar(this)) {
    setWindowTitle(tr("Database"));
    setObjectName(QStringLiteral("databasePage"));
    auto* const title = new QLabel(tr("Database"), this);
    QFont font = title->font();
    font.setPointSizeF(1.5 * font.pointSizeF());
    font.setBold(true);
    title->setFont(font);
    m_file->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_file->setWordWrap(true);
    m_state->setObjectName(QStringLiteral("databaseState"));
    m_state->setWordWrap(true);
    m_check->setObjectName(QStringLiteral("checkIntegrity"));
    m_check->setToolTip(tr("Reads every page and every document and compares their sums"));
    m_backup->setObjectName(QStringLiteral("backup"));
    m_backup->setProperty("primary", true);
    m_backup->setToolTip(tr("Writes a checked copy of this instant into one file; work goes on meanwhile"));
    m_restore->setObjectName(QStringLiteral("restore"));
    m_restore->setToolTip(tr("Puts a backup in place of the database. Not while a run is on."));
    m_bar->setRange(0, 0);
    m_bar->setTextVisible(true);
    m_bar->hide();
    m_rows->setObjectName(QStringLiteral("rows"));
    m_rows->setHorizontalHeaderLabels({tr("Table"), tr("Rows")});
    m_rows->verticalHeader()->hide();
    m_rows->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_rows->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_rows->setSelectionMode(QAbstractItemView::NoSelection);
    m_rows->setAlternatingRowColors(true);
    m_rows->setShowGrid(false);

    auto* const facts = new QGroupBox(tr("File"), this);
    auto* const form = new QFormLayout(facts);
    form->addRow(tr("Path"), m_file);
    form->addRow(tr("Size"), m_size);
    form->addRow(tr("Schema version"), m_version);
    auto* const counts = new QGroupBox(tr("What is in it"), this);
    auto* const inside = new QVBoxLayout(counts);
    inside->addWidget(m_rows);
    auto* const buttons = new QHBoxLayout;
    for (QPushButton* b : {m_check, m_backup, m_restore}) buttons->addWidget(b);
    buttons->addStretch(1);
    auto* const column = new QVBoxLayout;
    column->addWidget(title);
    column->addWidget(facts);
    column->addLayout(buttons);
    column->addWidget(m_bar);
    column->addWidget(m_state);
    column->addWidget(counts, 1);
    // One column, not wider than it can be read.
    auto* const middle = new QWidget(this);
    middle->setLayout(column);
    middle->setMaximumWidth(900);
    auto* const layout = new QHBoxLayout(this);
    layout->addWidget(middle);

    connect(m_check, &QPushButton::clicked, this, &DatabasePage::check);
    connect(m_backup, &QPushButton::clicked, this, [this] {
        const QString file = QFileDialog::getSaveFileName(
            this, tr("Back up the database"),
            QStringLiteral("sagara-%1.db").arg(QDate::currentDate().toString(Qt::ISODate)),
            tr("Databases (*.db)"));
        if (!file.isEmpty()) backupTo(file.toStdString());
    });
    connect(m_restore, &QPushButton::clicked, this, [this] {
        const QString file = QFileDialog::getOpenFileName(this, tr("Backup to restore"), QString(),
                                                          tr("Databases (*.db);;All files (*)"));
        if (!file.isEmpty()) restoreFrom(file.toStdString());
    });
    connect(&m_watcher, &QFutureWatcherBase::finished, this, [this] {
        m_busy = false;
        m_bar->hide();
        const Then then = std::move(m_then);
        const std::vector<std::string> wrong = m_watcher.result();
        showFacts();
        then(wrong);
    });
    showFacts();
}

DatabasePage::~DatabasePage() {
    m_watcher.disconnect(this);
    m_watcher.waitForFinished();
}

void DatabasePage::setColours(PaletteName name) {
    m_colours = name;
    m_check->setIcon(themedIcon(QStringLiteral("search"), name));
    m_backup->setIcon(
        QIcon(themedIcon(QStringLiteral("file-download-google"), name).pixmap(24, QIcon::Selected)));
    m_restore->setIcon(themedIcon(QStringLiteral("file-upload-google"), name));
    say(m_state->text(), m_bad);
}

void DatabasePage::say(const QString& text, bool bad) {
    m_bad = bad;
    m_state->setText(text);
    QPalette colours = palette();
    if (bad) colours.setColor(QPalette::WindowText, themeColours(m_colours).alarm);
    m_state->setPalette(colours);
}

void DatabasePage::showFacts() {
    const DatabaseCare::Facts facts = m_care.facts();
    const bool open = facts.trouble.empty();
    m_file->setText(q(facts.file));
    m_size->setText(open ? QLocale().formattedDataSize(facts.size_bytes) : tr("not known"));
    m_version->setText(open ? QString::number(facts.schemaVersion) : tr("not known"));
    m_rows->setRowCount(0);
    for (const auto& [table, rows] : facts.rows) {
        const int at = m_rows->rowCount();
        m_rows->insertRow(at);
        m_rows->setItem(at, 0, new QTableWidgetItem(QString::fromStdString(table)));
        auto* const count = new QTableWidgetItem(QLocale().toString(static_cast<qlonglong>(rows)));
        count->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_rows->setItem(at, 1, count);
    }
    m_check->setEnabled(open && !m_busy);
    m_backup->setEnabled(open && !m_busy);
    m_restore->setEnabled(!m_busy);
    if (!open)
        say(QString::fromStdString(facts.trouble) + tr(" Restore a backup, or mend what is said."), true);
}

void DatabasePage::aside(const QString& what, Work work, Then then) {
    if (m_busy) return;
    m_busy = true;
    m_then = std::move(then);
    m_bar->setFormat(what);
    m_bar->show();
    say(what, false);
    showFacts();
    m_watcher.setFuture(QtConcurrent::run(std::move(work)));
}

void DatabasePage::check() {
    aside(
        tr("Reading every page and every document…"), [this] { return m_care.checkIntegrity(); },
        [this](const std::vector<std::string>& wrong) {
            if (wrong.empty())
                say(tr("The database is whole: nothing is wrong with it."), false);
            else
                say(tr("Something is wrong. Restore a backup made before:\n%1").arg(joined(wrong)), true);
        });
}

void DatabasePage::backupTo(const std::filesystem::path& file) {
    aside(
        tr("Writing and checking the copy…"), [this, file] { return m_care.backupTo(file); },
        [this, file](const std::vector<std::string>& wrong) {
            if (wrong.empty())
                say(tr("Backed up to %1. Keep a copy on another disk.").arg(q(file)), false);
            else
                say(tr("No backup was made: %1").arg(joined(wrong)), true);
        });
}

void DatabasePage::restoreFrom(const std::filesystem::path& file, bool asked) {
    if (m_care.runIsOn()) return say(tr("A run is on. End it first, then restore."), true);
    if (!asked && QMessageBox::question(
                      this, tr("Restore"),
                      tr("Put %1 in place of the database? What was entered since that backup is then "
                         "no longer shown; the present database is kept beside it as %2.")
                          .arg(q(file), q(m_care.keptCopy()))) != QMessageBox::Yes)
        return;
    aside(
        tr("Checking the backup…"), [this, file] { return m_care.checkBackup(file); },
        [this, file](const std::vector<std::string>& wrong) {
            if (!wrong.empty())
                return say(tr("Not restored; the database is as it was: %1").arg(joined(wrong)), true);
            if (m_care.runIsOn()) return say(tr("A run is on. End it first, then restore."), true);
            const auto trouble = m_care.restore(file);
            showFacts();
            if (trouble)
                say(tr("Not restored: %1").arg(QString::fromStdString(*trouble)), true);
            else
                say(tr("Restored from %1. The database before is %2.").arg(q(file), q(m_care.keptCopy())),
                    false);
        });
}

}  // namespace sagara::ui
