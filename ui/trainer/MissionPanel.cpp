#include "ui/trainer/MissionPanel.h"

#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

#include "core/assess/Mission.h"
#include "ui/run/RunTexts.h"

namespace sagara::ui {
namespace {

QListWidget* list(QWidget* parent, const QString& name) {
    auto* const list = new QListWidget(parent);
    list->setObjectName(name);
    list->setSelectionMode(QAbstractItemView::NoSelection);
    list->setFocusPolicy(Qt::NoFocus);
    list->setWordWrap(true);
    return list;
}

}  // namespace

MissionPanel::MissionPanel(ExerciseRun& run, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_score(new QLabel(this)),
      m_tasks(list(this, QStringLiteral("tasks"))),
      m_log(list(this, QStringLiteral("log"))) {
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    QFont large = m_score->font();
    large.setPointSizeF(1.3 * large.pointSizeF());
    large.setBold(true);
    m_score->setFont(large);
    m_score->setObjectName(QStringLiteral("score"));
    m_score->setToolTip(tr("Automatic score, advisory"));
    layout->addWidget(m_score);
    layout->addWidget(m_tasks, 2);
    layout->addWidget(new QLabel(tr("What happened"), this));
    layout->addWidget(m_log, 3);
    for (const auto& task : run.world()->mission.tasks)
        m_tasks->addItem(QString::fromStdString(task->title()));
    if (m_tasks->count() == 0) m_tasks->addItem(tr("This scenario has no tasks."));
    refresh();
}

void MissionPanel::refresh() {
    const auto now = m_run.latest();
    const core::Mission& mission = m_run.world()->mission;
    m_score->setText(now->failed ? tr("Score %1 of 100, failed").arg(now->score, 0, 'f', 0)
                                 : tr("Score %1 of 100").arg(now->score, 0, 'f', 0));
    bool currentFound = false;
    for (std::size_t i = 0; i < std::min(now->tasks.size(), mission.tasks.size()); ++i) {
        const core::TaskView& task = now->tasks[i];
        QListWidgetItem* const item = m_tasks->item(static_cast<int>(i));
        const QString title = QString::fromStdString(mission.tasks[i]->title());
        const bool current = !task.done && !currentFound;
        currentFound = currentFound || current;
        const QString text = task.done ? tr("✓ %1  (%2)").arg(title, elapsed(task.doneAt))
                             : current ? tr("▸ %1").arg(title)
                                       : tr("   %1").arg(title);
        if (item->text() != text) item->setText(text);
    }
    if (now->tick < m_seen) {  // somebody went back
        m_log->clear();
        m_events = 0;
    }
    m_seen = now->tick;
    for (const core::Event& event : m_run.eventsFrom(m_events)) {
        ++m_events;
        const QString text = eventText(*m_run.world(), now->added, event);
        if (text.isEmpty()) continue;
        m_log->addItem(tr("%1  %2").arg(elapsed(event.time()), text));
        m_log->scrollToBottom();
    }
}

}  // namespace sagara::ui
