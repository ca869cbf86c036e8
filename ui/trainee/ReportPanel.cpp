#include "ui/trainee/ReportPanel.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/run/RunTexts.h"

namespace sagara::ui::console {

ReportPanel::ReportPanel(ExerciseRun& run, std::uint8_t ship, QWidget* parent)
    : QWidget(parent), m_run(run), m_ship(ship), m_last(new QLabel(this)) {
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(6, 6, 6, 6);
    const auto add = [&](int column, const QString& text, const QString& id, const QString& tip,
                         core::ReportKind kind) {
        auto* const button = new QPushButton(text, this);
        button->setObjectName(id);
        button->setToolTip(tip);
        connect(button, &QPushButton::clicked, this, [this, kind, text] { report(kind, text); });
        grid->addWidget(button, 0, column);
    };
    add(0, tr("Port control"), QStringLiteral("report-port"),
        tr("Calls port control on VHF with position and intention"), core::ReportKind::PortControl);
    add(1, tr("Anchored"), QStringLiteral("report-anchored"), tr("Reports the ship brought up to her anchor"),
        core::ReportKind::Anchored);
    add(2, tr("Man overboard"), QStringLiteral("report-mob"),
        tr("Raises the alarm: somebody is in the water"), core::ReportKind::ManOverboard);
    m_last->setObjectName(QStringLiteral("report-last"));
    m_last->setText(tr("Nothing reported yet."));
    grid->addWidget(m_last, 1, 0, 1, 3);
    grid->setRowStretch(2, 1);
}

void ReportPanel::report(core::ReportKind kind, const QString& text) {
    m_run.give(m_ship, core::ReportOrder{kind});
    m_last->setText(tr("%1: reported at %2").arg(text, localTime(*m_run.world(), m_run.latest()->time())));
}

}  // namespace sagara::ui::console
