#include "ui/trainee/RunControls.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <cmath>

namespace sagara::ui::console {

RunControls::RunControls(ExerciseRun& run, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_start(new QPushButton(this)),
      m_end(new QPushButton(tr("End"), this)),
      m_rate(new QComboBox(this)) {
    m_start->setObjectName(QStringLiteral("console-start"));
    m_start->setToolTip(tr("Start or freeze the exercise (Space)"));
    m_rate->setObjectName(QStringLiteral("console-rate"));
    m_rate->setToolTip(tr("Seconds of the exercise to one of the clock on the wall"));
    for (const int times : {1, 2, 5, 10, 20}) m_rate->addItem(tr("%1x").arg(times), times);
    m_end->setObjectName(QStringLiteral("console-end"));
    m_end->setToolTip(tr("End the exercise; it is graded as it stands"));
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_start);
    row->addWidget(m_rate);
    row->addWidget(m_end);
    connect(m_start, &QPushButton::clicked, this, [this] {
        m_run.running() ? m_run.freeze() : m_run.start();
        refresh();
    });
    m_start->setShortcut(Qt::Key_Space);
    connect(m_rate, &QComboBox::activated, this,
            [this](int index) { m_run.setRate(m_rate->itemData(index).toDouble()); });
    connect(m_end, &QPushButton::clicked, this, &RunControls::endWanted);
    refresh();
}

void RunControls::refresh() {
    const QString text = m_run.running()            ? tr("Freeze")
                         : m_run.latest()->tick > 0 ? tr("Go on")
                                                    : tr("Start");
    if (m_start->text() != text) {
        m_start->setText(text);
        m_start->setShortcut(Qt::Key_Space);  // a new text takes it away
    }
    m_start->setEnabled(!m_run.over());
    m_rate->setEnabled(!m_run.over());
    const int at = m_rate->findData(static_cast<int>(std::lround(m_run.rate())));
    if (at >= 0 && at != m_rate->currentIndex()) m_rate->setCurrentIndex(at);
}

}  // namespace sagara::ui::console
