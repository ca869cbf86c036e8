#include "ui/trainer/RunBar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/run/RunTexts.h"

namespace sagara::ui {

RunBar::RunBar(ExerciseRun& run, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_start(new QPushButton(this)),
      m_end(new QPushButton(tr("End and grade"), this)),
      m_rate(new QComboBox(this)),
      m_clock(new QLabel(this)),
      m_state(new QLabel(this)) {
    m_start->setObjectName(QStringLiteral("start"));
    m_start->setToolTip(tr("Start or freeze the exercise (Space)"));
    m_start->setShortcut(Qt::Key_Space);
    m_end->setObjectName(QStringLiteral("end"));
    m_end->setToolTip(tr("End the exercise; it is graded as it stands"));
    m_rate->setObjectName(QStringLiteral("rate"));
    m_rate->setToolTip(tr("Seconds of the exercise to one of the clock on the wall"));
    for (const int times : {1, 2, 5, 10, 20}) m_rate->addItem(tr("%1x").arg(times), times);
    m_clock->setObjectName(QStringLiteral("clock"));
    m_clock->setTextFormat(Qt::PlainText);

    auto* const layout = new QHBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 4);
    layout->addWidget(m_start);
    layout->addWidget(new QLabel(tr("Pace"), this));
    layout->addWidget(m_rate);
    layout->addSpacing(12);
    layout->addWidget(m_clock);
    layout->addStretch();
    layout->addWidget(m_state);
    layout->addSpacing(12);
    layout->addWidget(m_end);

    connect(m_start, &QPushButton::clicked, this, &RunBar::toggle);
    connect(m_rate, &QComboBox::currentIndexChanged, this,
            [this](int index) { m_run.setRate(m_rate->itemData(index).toDouble()); });
    connect(m_end, &QPushButton::clicked, this, &RunBar::endWanted);
    refresh();
}

void RunBar::toggle() {
    if (m_run.running())
        m_run.freeze();
    else
        m_run.start();
    refresh();
}

void RunBar::refresh() {
    const core::SimTime time = m_run.latest()->time();
    m_start->setText(m_run.running() ? tr("Freeze") : time.us > 0 ? tr("Go on") : tr("Start"));
    m_start->setEnabled(!m_run.over());
    m_rate->setEnabled(!m_run.over());
    m_clock->setText(tr("%1 elapsed    %2 local    %3")
                         .arg(elapsed(time), localTime(*m_run.world(), time), utcTime(*m_run.world(), time)));
    QString state;
    if (m_run.over())
        state = tr("The exercise is over.");
    else if (!m_run.trouble().empty())
        state = QString::fromStdString(m_run.trouble());
    else if (m_run.lagged_s() > 1.0)
        state = tr("This machine is too slow for this pace: %1 s lost").arg(m_run.lagged_s(), 0, 'f', 0);
    m_state->setText(state);
}

}  // namespace sagara::ui
