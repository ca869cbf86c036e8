#include "ui/trainer/RunBar.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTimeEdit>

#include "ui/run/RunTexts.h"

namespace sagara::ui {

RunBar::RunBar(ExerciseRun& run, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_start(new QPushButton(this)),
      m_goBack(new QPushButton(tr("Go back"), this)),
      m_end(new QPushButton(tr("End and grade"), this)),
      m_rate(new QComboBox(this)),
      m_clock(new QLabel(this)),
      m_state(new QLabel(this)) {
    m_start->setObjectName(QStringLiteral("start"));
    m_start->setToolTip(tr("Start or freeze the exercise (Space)"));
    m_start->setShortcut(Qt::Key_Space);
    m_end->setObjectName(QStringLiteral("end"));
    m_end->setToolTip(tr("End the exercise; it is graded as it stands"));
    m_goBack->setObjectName(QStringLiteral("go-back"));
    m_goBack->setMenu(new QMenu(m_goBack));
    connect(m_goBack->menu(), &QMenu::aboutToShow, this, &RunBar::fillGoBack);
    setMayGoBack(true);
    auto* const console = new QPushButton(tr("Console"), this);
    console->setObjectName(QStringLiteral("open-console"));
    console->setToolTip(
        tr("Open the trainee's console of this run in a window of its own, for another monitor"));
    connect(console, &QPushButton::clicked, this, &RunBar::consoleWanted);
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
    layout->addWidget(m_goBack);
    layout->addSpacing(12);
    layout->addWidget(m_clock);
    layout->addStretch();
    layout->addWidget(m_state);
    layout->addSpacing(12);
    layout->addWidget(console);
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

std::int64_t RunBar::sailed_s() const { return m_run.latest()->time().us / 1'000'000; }

void RunBar::setMayGoBack(bool may) {
    m_goBack->setEnabled(may);
    m_goBack->setToolTip(
        may ? tr("Sail again from an earlier second; what was sailed since is kept in a recording "
                 "of its own")
            : tr("An assessment is graded as it was sailed: it cannot go back"));
}

void RunBar::fillGoBack() {
    QMenu* const menu = m_goBack->menu();
    menu->clear();
    const std::int64_t now_s = sailed_s();
    const auto offer = [&](const QString& text, std::int64_t to_s) {
        QAction* const action = menu->addAction(text, this, [this, to_s] { Q_EMIT goBackWanted(to_s); });
        action->setObjectName(QStringLiteral("go-back-%1").arg(to_s));
    };
    for (const auto& [ago_s, text] : {std::pair{10, tr("10 seconds")}, std::pair{30, tr("30 seconds")},
                                      std::pair{60, tr("1 minute")}, std::pair{300, tr("5 minutes")}})
        if (now_s > ago_s) offer(tr("%1 back").arg(text), now_s - ago_s);
    if (now_s > 0) menu->addSeparator();
    for (const core::Event& event : m_run.eventsFrom(0)) {
        if (event.kind != core::EventKind::NoteMade || event.value == 0.0) continue;
        const QString text = QString::fromStdString(event.text);
        offer(text.isEmpty() ? tr("Bookmark at %1").arg(elapsed(event.time()))
                             : tr("%1: %2").arg(elapsed(event.time()), text),
              event.time().us / 1'000'000);
    }
    offer(tr("To the start"), 0);
    menu->addAction(tr("To a time ..."), this, &RunBar::askSecond);
}

void RunBar::askSecond() {
    m_run.freeze();
    const int last_s = static_cast<int>(sailed_s());
    QTimeEdit* const edit = new QTimeEdit(QTime(0, 0).addSecs(last_s));
    QDialog dialog(this);
    dialog.setWindowTitle(tr("Go back"));
    edit->setDisplayFormat(QStringLiteral("HH:mm:ss"));
    edit->setTimeRange(QTime(0, 0), QTime(0, 0).addSecs(last_s));
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
    connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    auto* const form = new QFormLayout(&dialog);
    form->addRow(tr("Time elapsed, up to %1").arg(elapsed(m_run.latest()->time())), edit);
    form->addRow(buttons);
    if (dialog.exec() == QDialog::Accepted) Q_EMIT goBackWanted(QTime(0, 0).secsTo(edit->time()));
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
