#include "ui/editor/DryRunPanel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "core/assess/MissionContext.h"
#include "ui/chart/Format.h"

namespace sagara::ui::editor {
namespace {

constexpr int kBeat_ms = 200;

QTableWidget* tableOf(const char* name, const QStringList& columns, QWidget* parent) {
    auto* const table = new QTableWidget(0, static_cast<int>(columns.size()), parent);
    table->setObjectName(QString::fromLatin1(name));
    table->setHorizontalHeaderLabels(columns);
    table->horizontalHeader()->setStretchLastSection(true);
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table->verticalHeader()->hide();
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setAlternatingRowColors(true);
    table->setMinimumHeight(120);
    table->hide();
    return table;
}

void addRow(QTableWidget& table, const QStringList& cells) {
    const int row = table.rowCount();
    table.insertRow(row);
    for (int i = 0; i < cells.size(); ++i) {
        auto* const item = new QTableWidgetItem(cells[i]);
        item->setToolTip(cells[i]);
        table.setItem(row, i, item);
    }
}

}  // namespace

DryRunPanel::DryRunPanel(EditorContext& context, QWidget* parent)
    : QWidget(parent),
      m_context(context),
      m_level(new QComboBox(this)),
      m_start(new QPushButton(words("Start the dry run"), this)),
      m_cancel(new QPushButton(words("Cancel"), this)),
      m_progress(new QProgressBar(this)),
      m_now(new QLabel(this)),
      m_result(new QLabel(this)),
      m_old(new QLabel(words("The scenario has been changed since this dry run."), this)),
      m_tasks(tableOf("dry-run-tasks", {words("Done at"), words("Task")}, this)),
      m_losses(tableOf("dry-run-losses", {words("Time"), words("Points"), words("Deduction")}, this)) {
    m_level->setObjectName(QStringLiteral("dry-run-level"));
    m_start->setObjectName(QStringLiteral("dry-run-start"));
    m_cancel->setObjectName(QStringLiteral("dry-run-cancel"));
    m_result->setObjectName(QStringLiteral("dry-run-result"));
    for (int i = 1; i <= core::kLevels; ++i) m_level->addItem(words("Level %1").arg(i), i);
    m_level->setCurrentIndex(2);
    m_level->setToolTip(words("Difficulty: weather, traffic and the time allowed"));
    m_start->setToolTip(words("The scripted pilot sails the scenario as it is now, many times faster than the clock"));
    m_start->setProperty("primary", true);
    m_cancel->setToolTip(words("Stop where she is"));
    m_progress->setTextVisible(false);
    m_losses->setToolTip(words("Click a deduction to see its place on the chart"));
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* const row = new QHBoxLayout;
    row->addWidget(m_level);
    row->addWidget(m_start, 1);
    row->addWidget(m_cancel);
    layout->addLayout(row);
    for (QLabel* label : {m_now, m_result, m_old}) label->setWordWrap(true);
    layout->addWidget(m_progress);
    layout->addWidget(m_now);
    layout->addWidget(m_old);
    layout->addWidget(m_result);
    layout->addWidget(m_tasks);
    layout->addWidget(m_losses, 1);
    layout->addStretch(0);
    for (QWidget* w : std::initializer_list<QWidget*>{m_progress, m_old, m_cancel}) w->hide();
    m_result->setText(words("The pilot's script is sailed, and graded as a trainee's run would be. Nothing is kept."));
    m_beat.setInterval(kBeat_ms);
    connect(&m_beat, &QTimer::timeout, this, &DryRunPanel::tick);
    connect(m_start, &QPushButton::clicked, this, &DryRunPanel::start);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_run.cancel(); });
    connect(&m_run, &DryRun::finished, this, &DryRunPanel::finish);
    connect(&context.draft(), &ScenarioDraft::changed, this, [this] {
        m_old->setVisible(m_sailed && !m_run.running() && m_sailed != m_context.draft().shared());
    });
    connect(m_losses, &QTableWidget::cellClicked, this, [this](int at, int) {
        const auto& losses = m_run.result().losses;
        if (static_cast<std::size_t>(at) < losses.size()) Q_EMIT placeChosen(losses[static_cast<std::size_t>(at)].place);
    });
}

void DryRunPanel::start() {
    m_sailed = m_context.draft().shared();
    m_run.start(m_sailed->dump(), m_context.documents(), m_level->currentData().toInt());
    m_start->setEnabled(false);
    for (QWidget* w : std::initializer_list<QWidget*>{m_progress, m_cancel}) w->show();
    for (QWidget* w : std::initializer_list<QWidget*>{m_old, m_result, m_tasks, m_losses}) w->hide();
    m_progress->setRange(0, 0);
    m_now->setText(words("Reading the documents …"));
    m_now->show();
    m_beat.start();
}

void DryRunPanel::tick() {
    const DryRun::Progress now = m_run.progress();
    if (now.longest_s <= 0.0) return;
    m_progress->setRange(0, static_cast<int>(now.longest_s));
    m_progress->setValue(static_cast<int>(now.time_s));
    m_now->setText(words("%1 of at most %2: %3; score %4; %5 times real time")
                       .arg(runTime(now.time_s), runTime(now.longest_s), now.task, chart::number(now.score, 0),
                            chart::number(now.timesRealTime, 0)));
}

void DryRunPanel::finish() {
    m_beat.stop();
    m_start->setEnabled(true);
    for (QWidget* w : std::initializer_list<QWidget*>{m_progress, m_now, m_cancel}) w->hide();
    showResult(m_run.result());
    m_old->setVisible(m_sailed != m_context.draft().shared());
    Q_EMIT trackChanged();
    if (!m_run.result().problems.empty()) Q_EMIT problemsFound();
}

void DryRunPanel::showResult(const DryRunResult& r) {
    m_result->show();
    m_tasks->setRowCount(0);
    m_losses->setRowCount(0);
    if (!r.problems.empty())
        return m_result->setText(words("It cannot be sailed yet: mend the problems listed below the chart."));
    QString text;
    if (r.cancelled) text = words("<b>Cancelled</b> after %1. As far as it went:").arg(runTime(r.time_s));
    else text = words("<b>%1</b> in %2.").arg(r.passed ? words("Passed") : words("Not passed"), runTime(r.time_s));
    text += words(" Score <b>%1</b> of 100, %2 to pass.").arg(chart::number(r.score, 0), chart::number(r.passScore, 0));
    if (!r.failedBy.isEmpty()) text += words(" Failed by: %1.").arg(r.failedBy.toHtmlEscaped());
    if (r.losses.empty()) text += words(" No points were deducted.");
    m_result->setText(text);
    for (const auto& task : r.tasks) addRow(*m_tasks, {task.done ? runTime(task.time_s) : words("not done"), task.title});
    for (const auto& loss : r.losses)
        addRow(*m_losses, {runTime(loss.time_s), QStringLiteral("−") + chart::shortNumber(loss.points, 1),
                           words("%1: %2").arg(loss.title, loss.found)});
    m_tasks->setVisible(!r.tasks.empty());
    m_losses->setVisible(!r.losses.empty());
    m_losses->resizeColumnToContents(0);
    m_losses->resizeColumnToContents(1);
}

}  // namespace sagara::ui::editor
