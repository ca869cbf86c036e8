#include "ui/trainee/AnchorPanel.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <array>
#include <cmath>

#include "core/base/Units.h"
#include "ui/trainee/LinePanel.h"
#include "ui/trainee/TensionBar.h"

namespace sagara::ui::console {
namespace {

QString statusText(const core::AnchorState& anchor) {
    switch (anchor.status) {
        case core::AnchorStatus::Home:
            return AnchorPanel::tr("home");
        case core::AnchorStatus::Running:
            return AnchorPanel::tr("running out");
        case core::AnchorStatus::Held:
            return anchor.onBottom ? AnchorPanel::tr("brake on")
                                   : AnchorPanel::tr("brake on, off the bottom");
        case core::AnchorStatus::Veering:
            return AnchorPanel::tr("veering");
        case core::AnchorStatus::Heaving:
            return AnchorPanel::tr("heaving in");
        case core::AnchorStatus::CableParted:
            return AnchorPanel::tr("cable parted");
    }
    return {};
}

}  // namespace

AnchorPanel::AnchorPanel(ExerciseRun& run, std::uint8_t ship, QWidget* parent)
    : QWidget(parent), m_run(run), m_ship(ship) {
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(6, 4, 6, 4);
    grid->setVerticalSpacing(2);
    grid->setHorizontalSpacing(4);
    grid->setColumnStretch(1, 1);
    const std::size_t anchors = run.world()->ships[ship]->anchorCount();
    for (std::size_t i = 0; i < anchors; ++i) addRow(i);
    if (anchors == 0) {
        auto* const none = new QLabel(tr("This ship has no anchor."), this);
        none->setAlignment(Qt::AlignCenter);
        grid->addWidget(none, 0, 0);
    }
    grid->setRowStretch(grid->rowCount(), 1);
}

void AnchorPanel::addRow(std::size_t anchor) {
    auto* const grid = static_cast<QGridLayout*>(layout());
    const core::AnchorGear& gear = m_run.world()->ships[m_ship]->vessel.groundTackle.anchors[anchor];
    const QString name = tr("%1 anchor").arg(spokenName(gear.id));
    const int at = 2 * static_cast<int>(anchor);
    Row row{new QLabel(this), new TensionBar(gear.breakingLoad_N, this), new QDoubleSpinBox(this), {}};
    row.state->setObjectName(QStringLiteral("anchor-state-%1").arg(anchor));
    const double most = std::floor(10.0 * gear.cableLength_m / core::kShackle_m) / 10.0;
    row.shackles->setObjectName(QStringLiteral("anchor-shackles-%1").arg(anchor));
    row.shackles->setRange(0.5, most);
    row.shackles->setSingleStep(0.5);
    row.shackles->setDecimals(1);
    row.shackles->setValue(std::min(4.0, most));
    row.shackles->setSuffix(tr(" sh"));
    row.shackles->setToolTip(
        tr("Brake on with so much cable out, 0.5 to %1 shackles of 27.4 m; for Let go and Veer").arg(most));
    auto* const head = new QLabel(QStringLiteral("<b>%1</b>").arg(name.toHtmlEscaped()), this);
    grid->addWidget(head, at, 0);
    grid->addWidget(row.state, at, 1);
    grid->addWidget(row.strain, at, 2, 1, 4);
    auto* const brake = new QLabel(tr("brake on at"), this);
    brake->setBuddy(row.shackles);
    auto* const target = new QHBoxLayout;
    target->addStretch();
    target->addWidget(brake);
    target->addWidget(row.shackles);
    grid->addLayout(target, at + 1, 0, 1, 2);
    const std::array<std::pair<QString, QString>, 4> actions{
        {{tr("Let go"), tr("%1: let go; the brake goes on at the cable set beside")},
         {tr("Veer"), tr("%1: walk out cable to the length set beside")},
         {tr("Hold"), tr("%1: brake on now")},
         {tr("Heave in"), tr("%1: heave in until it is home, or until hold is ordered")}}};
    for (std::size_t i = 0; i < actions.size(); ++i) {
        auto* const button = new QToolButton(this);
        button->setText(actions[i].first);
        button->setToolTip(actions[i].second.arg(name));
        button->setObjectName(QStringLiteral("anchor-%1-%2").arg(anchor).arg(i));
        connect(button, &QToolButton::clicked, this,
                [this, anchor, i] { order(anchor, static_cast<core::AnchorAction>(i)); });
        grid->addWidget(button, at + 1, 2 + static_cast<int>(i));
        row.buttons.push_back(button);
    }
    m_rows.push_back(row);
}

void AnchorPanel::order(std::size_t anchor, core::AnchorAction action) {
    const double cable_m =
        action == core::AnchorAction::HeaveIn ? 0.0 : m_rows[anchor].shackles->value() * core::kShackle_m;
    m_run.give(m_ship, core::AnchorOrder{static_cast<std::uint8_t>(anchor), action, cable_m});
}

void AnchorPanel::setColours(PaletteName name) {
    for (const Row& row : m_rows) row.strain->setColours(name);
}

void AnchorPanel::show(const core::OwnShipView& ship) {
    for (std::size_t i = 0; i < std::min(m_rows.size(), ship.anchors.size()); ++i) {
        const core::AnchorState& anchor = ship.anchors[i];
        const Row& row = m_rows[i];
        const bool home = anchor.status == core::AnchorStatus::Home;
        const bool lost = anchor.status == core::AnchorStatus::CableParted;
        const QString text = home || lost ? statusText(anchor)
                                          : tr("%1 shackles (%2 m), %3")
                                                .arg(anchor.cableOut_m / core::kShackle_m, 0, 'f', 1)
                                                .arg(anchor.cableOut_m, 0, 'f', 0)
                                                .arg(statusText(anchor));
        if (row.state->text() != text) row.state->setText(text);
        row.strain->setTension(anchor.hawseTension_N);
        row.buttons[0]->setEnabled(home);
        for (const std::size_t k : {1u, 2u, 3u}) row.buttons[k]->setEnabled(!home && !lost);
    }
}

}  // namespace sagara::ui::console
