#include "ui/practise/SailResultPage.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/run/RunTexts.h"

namespace sagara::ui {
namespace {

constexpr double kBefore_s = 20.0;
constexpr int kRow_px = 36;

QString clockOf(double time_s) { return elapsed(core::SimTime{static_cast<std::int64_t>(time_s * 1e6)}); }

QLabel* words(const QString& text, double scale, bool bold, QWidget* parent) {
    auto* const label = new QLabel(text, parent);
    QFont font = label->font();
    font.setPointSizeF(scale * font.pointSizeF());
    font.setBold(bold);
    label->setFont(font);
    label->setWordWrap(true);
    return label;
}

QTableWidget* table(const QString& name, const QStringList& heads, QWidget* parent) {
    auto* const made = new QTableWidget(0, static_cast<int>(heads.size()), parent);
    made->setObjectName(name);
    made->setHorizontalHeaderLabels(heads);
    made->verticalHeader()->hide();
    made->setEditTriggers(QAbstractItemView::NoEditTriggers);
    made->setSelectionMode(QAbstractItemView::NoSelection);
    made->setShowGrid(false);
    made->setAlternatingRowColors(true);
    made->setWordWrap(true);
    made->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    made->verticalHeader()->setDefaultSectionSize(kRow_px);
    made->setFocusPolicy(Qt::NoFocus);  // the buttons in it have it
    return made;
}

/// No taller than its rows.
void fitRows(QTableWidget* table) {
    table->setMaximumHeight(table->horizontalHeader()->sizeHint().height() + kRow_px * table->rowCount() + 4);
}

QTableWidgetItem* cell(const QString& text, bool right = false) {
    auto* const item = new QTableWidgetItem(text);
    item->setToolTip(text);
    if (right) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return item;
}

}  // namespace

double SailResultPage::replayFrom_s(double loss_s) { return std::max(0.0, loss_s - kBefore_s); }

SailResultPage::SailResultPage(SailResult result, Ports ports, QWidget* parent)
    : Page(parent),
      m_result(std::move(result)),
      m_ports(std::move(ports)),
      m_trouble(words({}, 1.0, true, this)) {
    setObjectName(QStringLiteral("sail-result"));
    setWindowTitle(tr("Result: %1").arg(m_result.name));
    m_trouble->setObjectName(QStringLiteral("trouble"));
    m_trouble->setText(m_result.trouble);
    m_trouble->setVisible(!m_result.trouble.isEmpty());
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(28, 20, 28, 20);
    layout->setSpacing(10);
    layout->addWidget(head());
    layout->addWidget(m_trouble);
    if (!m_result.tasks.empty()) {
        layout->addWidget(words(tr("Tasks"), 1.15, true, this));
        layout->addWidget(taskTable(), 2);
    }
    if (m_result.graded) {
        layout->addWidget(words(tr("Points lost"), 1.15, true, this));
        if (m_result.losses.empty())
            layout->addWidget(words(tr("None: every limit was kept."), 1.0, false, this));
        else
            layout->addWidget(lossTable(), 3);
    }
    layout->addStretch(1);
    auto* const buttons = new QHBoxLayout;
    const auto button = [&](const QString& text, const QString& name, const QString& tip, auto&& act) {
        auto* const made = new QPushButton(text, this);
        made->setObjectName(name);
        made->setToolTip(tip);
        connect(made, &QPushButton::clicked, this, act);
        buttons->addWidget(made);
        return made;
    };
    button(tr("Replay all of it"), QStringLiteral("replay-all"),
           tr("The debriefing of this run from its start"),
           [this] { run([this] { return m_ports.replay(0.0); }); })
        ->setEnabled(!m_result.recording.empty());
    buttons->addStretch();
    button(tr("Sail again"), QStringLiteral("again"), tr("The same exercise from its start, as a new run"),
           [this] { run(m_ports.again); });
    button(tr("Done"), QStringLiteral("done"), tr("Back to the choice (Esc)"), [this] {
        Q_EMIT leaveWanted();
    })->setProperty("primary", true);
    layout->addLayout(buttons);
}

void SailResultPage::run(const std::function<std::optional<std::string>()>& act) {
    const auto trouble = act ? act() : std::nullopt;
    m_trouble->setVisible(trouble.has_value());
    if (trouble) m_trouble->setText(QString::fromStdString(*trouble));
}

QWidget* SailResultPage::head() {
    auto* const box = new QWidget(this);
    auto* const layout = new QVBoxLayout(box);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(words(m_result.name, 1.7, true, box));
    QString result = tr("Sailed %1. Nothing was graded.").arg(clockOf(m_result.sailed_s));
    if (m_result.graded)
        result = tr("%1, %2 of 100 points. Sailed %3.")
                     .arg(m_result.passed ? tr("Passed") : tr("Not passed"))
                     .arg(m_result.score, 0, 'f', 0)
                     .arg(clockOf(m_result.sailed_s));
    QLabel* const line = words(result, 1.35, true, box);
    line->setObjectName(QStringLiteral("result-line"));
    layout->addWidget(line);
    if (m_result.graded && !m_result.passed && !m_result.whyNot.isEmpty())
        layout->addWidget(words(m_result.whyNot, 1.0, false, box));
    if (m_result.graded)
        layout->addWidget(words(tr("Self-study: the score is automatic, for yourself, and never a grade."),
                                1.0, false, box));
    if (!m_result.best.isEmpty()) {
        QLabel* const best = words(m_result.best, 1.0, true, box);
        best->setObjectName(QStringLiteral("result-best"));
        layout->addWidget(best);
    }
    return box;
}

QTableWidget* SailResultPage::taskTable() {
    QTableWidget* const made =
        table(QStringLiteral("result-tasks"), {tr("Task"), tr("Done at (min:s)")}, this);
    for (const SailResult::Task& task : m_result.tasks) {
        const int row = made->rowCount();
        made->insertRow(row);
        made->setItem(row, 0, cell(task.title));
        made->setItem(row, 1, cell(task.done ? clockOf(task.time_s) : tr("not done")));
    }
    made->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    made->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    fitRows(made);
    return made;
}

QTableWidget* SailResultPage::lossTable() {
    QTableWidget* const made =
        table(QStringLiteral("result-losses"),
              {tr("At (min:s)"), tr("Limit"), tr("What happened"), tr("Points"), {}}, this);
    for (const SailResult::Loss& loss : m_result.losses) {
        const int row = made->rowCount();
        made->insertRow(row);
        made->setItem(row, 0, cell(clockOf(loss.time_s), true));
        made->setItem(row, 1, cell(loss.fails ? tr("%1 (fails the run)").arg(loss.title) : loss.title));
        made->setItem(row, 2, cell(loss.detail));
        made->setItem(row, 3, cell(tr("−%1").arg(loss.points, 0, 'f', 0), true));
        auto* const replay = new QPushButton(tr("Replay"), made);
        replay->setObjectName(QStringLiteral("replay-%1").arg(row));
        replay->setToolTip(tr("The debriefing, 20 s before this"));
        replay->setEnabled(!m_result.recording.empty());
        connect(replay, &QPushButton::clicked, this, [this, time_s = loss.time_s] {
            run([this, time_s] { return m_ports.replay(replayFrom_s(time_s)); });
        });
        made->setCellWidget(row, 4, replay);
    }
    for (const int column : {0, 1, 3})
        made->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    made->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
    made->horizontalHeader()->setSectionResizeMode(4, QHeaderView::Fixed);
    made->setColumnWidth(4, 110);
    fitRows(made);
    return made;
}

}  // namespace sagara::ui
