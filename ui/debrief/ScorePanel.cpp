#include "ui/debrief/ScorePanel.h"

#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/chart/Format.h"
#include "ui/run/RunTexts.h"
#include "ui/theme/ThemeColours.h"

namespace sagara::ui {
namespace {

enum Column { Time, What, Points };
constexpr int kTimeRole = Qt::UserRole;

core::SimTime simTime(double time_s) { return {std::llround(1e6 * time_s)}; }

/// Two lines: the panel is narrow.
QString lossText(const ReplayResult::Loss& loss) {
    return ScorePanel::tr("%1\n%2 %3, limit %4")
        .arg(QString::fromStdString(loss.title), chart::number(loss.value, 2),
             QString::fromStdString(loss.unit), chart::number(loss.limit, 2));
}

}  // namespace

ScorePanel::ScorePanel(QWidget* parent)
    : QWidget(parent),
      m_score(new QLabel(this)),
      m_verdict(new QLabel(this)),
      m_advisory(new QLabel(this)),
      m_list(new QTreeWidget(this)) {
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(3);
    QFont large = m_score->font();
    large.setPointSizeF(1.4 * large.pointSizeF());
    large.setBold(true);
    m_score->setFont(large);
    m_score->setObjectName(QStringLiteral("score"));
    m_verdict->setObjectName(QStringLiteral("verdict"));
    m_verdict->setWordWrap(true);
    m_advisory->setWordWrap(true);
    m_list->setObjectName(QStringLiteral("score-list"));
    m_list->setHeaderLabels({tr("Time"), tr("What"), tr("Points")});
    m_list->setRootIsDecorated(false);
    m_list->setIndentation(0);
    m_list->setUniformRowHeights(false);
    m_list->setTextElideMode(Qt::ElideRight);
    m_list->setToolTip(tr("Click a line, or press Enter on it, to go to its moment"));
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(Time, QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(What, QHeaderView::Stretch);
    m_list->header()->setSectionResizeMode(Points, QHeaderView::ResizeToContents);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    for (QLabel* label : {m_score, m_verdict, m_advisory}) layout->addWidget(label);
    layout->addWidget(m_list, 1);
    const auto go = [this](QTreeWidgetItem* item) {
        const QVariant time = item->data(Time, kTimeRole);
        if (time.isValid()) Q_EMIT picked({time.toLongLong()});
    };
    connect(m_list, &QTreeWidget::itemClicked, this, go);
    connect(m_list, &QTreeWidget::itemActivated, this, go);
}

void ScorePanel::setColours(PaletteName name) {
    m_colours = name;
    fill();
}

void ScorePanel::setResult(const ReplayResult& result) {
    m_result = result;
    fill();
}

void ScorePanel::setNotes(const std::vector<DebriefMark>& marks) {
    m_notes.clear();
    for (const DebriefMark& mark : marks)
        if (mark.kind == MarkKind::Note) m_notes.push_back(mark);
    fill();
}

void ScorePanel::fill() {
    const ThemeColours& c = themeColours(m_colours);
    m_score->setText(tr("%1 of 100 points").arg(chart::number(m_result.score, 0)));
    m_verdict->setText(m_result.passed
                           ? tr("Passed (%1 points needed)").arg(chart::number(m_result.passScore, 0))
                           : tr("Not passed: %1").arg(QString::fromStdString(m_result.whyNot)));
    m_advisory->setText(
        tr("Automatic score, advisory. Graded from %1.").arg(QString::fromStdString(m_result.gradedFrom)));
    m_list->clear();
    const auto header = [&](const QString& text) {
        auto* const item = new QTreeWidgetItem(m_list, {text});
        item->setFirstColumnSpanned(true);
        item->setFlags(Qt::ItemIsEnabled);
        QFont bold = m_list->font();
        bold.setBold(true);
        item->setFont(0, bold);
        for (int i = 0; i < 3; ++i) item->setBackground(i, c.section);
    };
    const auto line = [&](double time_s, bool timed, const QString& what, const QString& points) {
        const core::SimTime time = simTime(time_s);
        auto* const item =
            new QTreeWidgetItem(m_list, {timed ? elapsed(time) : QStringLiteral("–"), what, points});
        if (timed) item->setData(Time, kTimeRole, QVariant::fromValue<qlonglong>(time.us));
        item->setToolTip(What, what);
        item->setTextAlignment(Points, Qt::AlignRight | Qt::AlignTop);
        item->setTextAlignment(Time, Qt::AlignRight | Qt::AlignTop);
        return item;
    };
    header(tr("Tasks"));
    if (m_result.tasks.empty()) line(0.0, false, tr("This exercise has no tasks."), {});
    for (const auto& task : m_result.tasks) {
        QTreeWidgetItem* const item = line(task.time_s, task.done, QString::fromStdString(task.title),
                                           task.done ? QStringLiteral("✓") : tr("not done"));
        item->setForeground(Points, task.done ? c.starboard : c.port);
    }
    header(tr("Deductions"));
    if (m_result.losses.empty()) line(0.0, false, tr("No points were deducted."), {});
    for (const auto& loss : m_result.losses) {
        QTreeWidgetItem* const item =
            line(loss.time_s, true, lossText(loss),
                 loss.fails ? tr("fails") : QStringLiteral("−%1").arg(chart::number(loss.points, 0)));
        item->setForeground(Points, c.port);
        item->setToolTip(What, tr("%1: %2").arg(QString::fromStdString(loss.quantity), lossText(loss)));
    }
    if (!m_notes.empty()) header(tr("Notes"));
    for (const DebriefMark& note : m_notes) line(note.time.seconds(), true, note.text, {});
    setNow(m_now);
}

void ScorePanel::setNow(core::SimTime time) {
    m_now = time;
    const ThemeColours& c = themeColours(m_colours);
    for (int i = 0; i < m_list->topLevelItemCount(); ++i) {
        QTreeWidgetItem* const item = m_list->topLevelItem(i);
        const QVariant at = item->data(Time, kTimeRole);
        if (!at.isValid()) continue;
        const QBrush brush(at.toLongLong() <= time.us ? c.text : c.quietText);
        if (item->foreground(What) == brush) continue;
        item->setForeground(Time, brush);
        item->setForeground(What, brush);
    }
}

}  // namespace sagara::ui
