#include "ui/debrief/SailPanel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/run/RunTexts.h"
#include "ui/trainer/HelmPanel.h"

namespace sagara::ui {

SailPanel::SailPanel(Branch& branch, QWidget* parent)
    : QWidget(parent),
      m_branch(branch),
      m_clock(new QLabel(this)),
      m_trouble(new QLabel(this)),
      m_start(new QPushButton(this)),
      m_rate(new QComboBox(this)) {
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    auto* const what =
        new QLabel(tr("What if? Sailed anew from %1. The recording stays as it is; this run is "
                      "recorded on its own as training.")
                       .arg(elapsed(branch.from())),
                   this);
    what->setWordWrap(true);
    layout->addWidget(what);
    QFont bold = m_clock->font();
    bold.setBold(true);
    bold.setPointSizeF(1.25 * bold.pointSizeF());
    m_clock->setFont(bold);
    m_clock->setObjectName(QStringLiteral("branch-clock"));
    m_clock->setToolTip(tr("Time since the start of the exercise"));
    layout->addWidget(m_clock);

    auto* const run = new QHBoxLayout;
    m_start->setObjectName(QStringLiteral("branch-start"));
    m_start->setProperty("primary", true);
    m_start->setToolTip(tr("Time runs, or stands"));
    connect(m_start, &QPushButton::clicked, this, [this] {
        m_branch.running() ? m_branch.freeze() : m_branch.start();
        refresh();
    });
    m_rate->setObjectName(QStringLiteral("branch-rate"));
    m_rate->setToolTip(tr("Pace: seconds of the run in a second of the clock"));
    for (const double rate : {1.0, 2.0, 5.0, 10.0, 20.0})
        m_rate->addItem(QStringLiteral("%1×").arg(rate), rate);
    connect(m_rate, &QComboBox::currentIndexChanged, this,
            [this](int index) { m_branch.setRate(m_rate->itemData(index).toDouble()); });
    run->addWidget(m_start, 1);
    run->addWidget(m_rate);
    layout->addLayout(run);
    if (!branch.world()->ships.empty()) {
        m_helm = new HelmPanel(branch, 0, this);
        layout->addWidget(m_helm);
    }
    m_trouble->setWordWrap(true);
    layout->addWidget(m_trouble);
    layout->addStretch(1);
    auto* const compare = new QPushButton(tr("Compare"), this);
    compare->setObjectName(QStringLiteral("compare"));
    compare->setToolTip(tr("Freeze, and lay this run and the recorded one side by side"));
    connect(compare, &QPushButton::clicked, this, &SailPanel::compareWanted);
    auto* const end = new QPushButton(tr("End what if"), this);
    end->setObjectName(QStringLiteral("branch-end"));
    end->setToolTip(tr("End and file this run, and go back to the recording"));
    connect(end, &QPushButton::clicked, this, &SailPanel::endWanted);
    auto* const buttons = new QHBoxLayout;
    buttons->addWidget(compare, 1);
    buttons->addWidget(end);
    layout->addLayout(buttons);
    refresh();
}

void SailPanel::refresh() {
    const auto now = m_branch.latest();
    m_clock->setText(
        tr("%1   %2 local").arg(elapsed(now->time()), localTime(*m_branch.world(), now->time())));
    m_start->setText(m_branch.running() ? tr("Freeze") : tr("Start"));
    m_start->setEnabled(!m_branch.over());
    if (m_helm != nullptr) {
        m_helm->refresh();
        m_helm->setEnabled(!m_branch.over());
    }
    QString words = QString::fromStdString(m_branch.trouble());
    if (words.isEmpty() && m_branch.over()) words = tr("This run is over: compare it with the recorded one.");
    if (words.isEmpty() && m_branch.lagged_s() > 1.0)
        words = tr("The machine is too slow for this pace: %1 s behind.").arg(m_branch.lagged_s(), 0, 'f', 0);
    m_trouble->setText(words);
}

}  // namespace sagara::ui
