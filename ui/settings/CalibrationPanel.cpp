#include "ui/settings/CalibrationPanel.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/settings/AxisBar.h"

namespace sagara::ui {

CalibrationPanel::CalibrationPanel(int axis, const QString& name, const AxisCalibration& before,
                                   QWidget* parent)
    : QFrame(parent),
      m_axis(axis),
      m_run(before),
      m_step(new QLabel(this)),
      m_read(new QLabel(this)),
      m_bar(new AxisBar(this)),
      m_next(new QPushButton(this)) {
    setObjectName(QStringLiteral("calibration"));
    setFrameShape(QFrame::StyledPanel);
    m_step->setObjectName(QStringLiteral("calibration-step"));
    m_step->setWordWrap(true);
    m_next->setObjectName(QStringLiteral("calibration-next"));
    m_next->setProperty("primary", true);
    m_next->setToolTip(tr("Go on when what is asked above is done"));
    auto* const cancel = new QPushButton(tr("Cancel"), this);
    cancel->setObjectName(QStringLiteral("calibration-cancel"));
    cancel->setToolTip(tr("Leave the calibration as it was"));
    auto* const title = new QLabel(tr("Calibrate %1").arg(name), this);
    QFont bold = title->font();
    bold.setBold(true);
    title->setFont(bold);
    auto* const grid = new QGridLayout(this);
    grid->addWidget(title, 0, 0, 1, 3);
    grid->addWidget(m_step, 1, 0, 1, 3);
    grid->addWidget(m_bar, 2, 0, 1, 3);
    grid->addWidget(m_read, 3, 0);
    grid->addWidget(cancel, 3, 1);
    grid->addWidget(m_next, 3, 2);
    grid->setColumnStretch(0, 1);
    connect(m_next, &QPushButton::clicked, this, &CalibrationPanel::goOn);
    connect(cancel, &QPushButton::clicked, this, &CalibrationPanel::cancelled);
    tell();
    m_next->setFocus();
}

void CalibrationPanel::setColours(PaletteName palette) { m_bar->setColours(palette); }

void CalibrationPanel::feed(double raw) {
    m_run.feed(raw);
    const AxisCalibration& c = m_run.found();
    const bool ends = m_run.step() == CalibrationRun::Step::Ends;
    m_bar->show(ends && usable(c) ? c : AxisCalibration{}, raw);
    const auto number = [](double value) { return QString::number(100.0 * value, 'f', 0); };
    m_read->setText(ends ? tr("read %1 %, found %2 % to %3 %, middle %4 %")
                               .arg(number(raw), number(c.least), number(c.most), number(c.centre))
                         : tr("read %1 %").arg(number(raw)));
    tell();
}

void CalibrationPanel::tell() {
    const bool middle = m_run.step() == CalibrationRun::Step::Middle;
    const QString step =
        middle ? tr("Step 1 of 2: put the control in its middle (a wheel amidships, a lever at stop), let go "
                    "of it, then press Next.")
               : tr("Step 2 of 2: move the control slowly to one end and to the other, then press Done. Each "
                    "end must be at least %1 % away from the middle.")
                     .arg(100.0 * kLeastTravel, 0, 'f', 0);
    if (m_step->text() != step) m_step->setText(step);
    m_next->setText(middle ? tr("Next") : tr("Done"));
    if (m_next->isEnabled() == m_run.mayGoOn()) return;
    m_next->setEnabled(m_run.mayGoOn());
    if (m_next->isEnabled()) m_next->setFocus();  // a disabled one gives the focus to Cancel
}

void CalibrationPanel::goOn() {
    m_run.next();
    if (m_run.step() == CalibrationRun::Step::Done)
        Q_EMIT found(m_run.found());
    else
        tell();
}

}  // namespace sagara::ui
