#include "ui/trainee/LinePanel.h"

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>
#include <array>

#include "ui/trainee/TensionBar.h"

namespace sagara::ui::console {
namespace {

QString statusText(core::LineStatus status) {
    switch (status) {
        case core::LineStatus::In:
            return LinePanel::tr("in");
        case core::LineStatus::Fast:
            return LinePanel::tr("fast");
        case core::LineStatus::Slacking:
            return LinePanel::tr("slacking");
        case core::LineStatus::Heaving:
            return LinePanel::tr("heaving");
        case core::LineStatus::CastOff:
            return LinePanel::tr("let go, coming in");
        case core::LineStatus::Parted:
            return LinePanel::tr("parted");
    }
    return {};
}

}  // namespace

QString spokenName(const std::string& id) {
    QString name = QString::fromStdString(id).replace(QLatin1Char('-'), QLatin1Char(' '));
    if (!name.isEmpty()) name[0] = name[0].toUpper();
    return name;
}

LinePanel::LinePanel(ExerciseRun& run, std::uint8_t ship, QWidget* parent)
    : QWidget(parent), m_run(run), m_ship(ship) {
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(6, 4, 6, 4);
    grid->setVerticalSpacing(2);
    grid->setHorizontalSpacing(4);
    grid->setColumnStretch(2, 1);
    const std::size_t lines = run.world()->ships[ship]->lines.size();
    for (std::size_t i = 0; i < lines; ++i) addRow(i);
    if (lines == 0) {
        auto* const none = new QLabel(tr("No line is ashore in this exercise."), this);
        none->setAlignment(Qt::AlignCenter);
        grid->addWidget(none, 0, 0, 1, 7);
    }
    grid->setRowStretch(grid->rowCount(), 1);
}

void LinePanel::addRow(std::size_t line) {
    auto* const grid = static_cast<QGridLayout*>(layout());
    const core::OwnShip& own = *m_run.world()->ships[m_ship];
    const int at = static_cast<int>(line);
    const QString name = spokenName(own.lineIds[line]);
    Row row{new QLabel(this), new TensionBar(own.vessel.mooring.breakingLoad_N, this), {}};
    row.state->setObjectName(QStringLiteral("line-state-%1").arg(line));
    grid->addWidget(new QLabel(name, this), at, 0);
    grid->addWidget(row.state, at, 1);
    grid->addWidget(row.tension, at, 2);
    const std::array<std::pair<QString, QString>, 4> actions{
        {{tr("Hold"), tr("%1: hold the length, brake on")},
         {tr("Slack"), tr("%1: pay out until hold is ordered")},
         {tr("Heave"), tr("%1: heave in as far as the winch can pull")},
         {tr("Let go"), tr("%1: off the bollard and in; it cannot be sent ashore again")}}};
    for (std::size_t i = 0; i < actions.size(); ++i) {
        auto* const button = new QToolButton(this);
        button->setText(actions[i].first);
        button->setToolTip(actions[i].second.arg(name));
        button->setCheckable(i != 3);
        button->setObjectName(QStringLiteral("line-%1-%2").arg(line).arg(i));
        connect(button, &QToolButton::clicked, this, [this, line, i] {
            m_run.give(m_ship,
                       core::LineOrder{static_cast<std::uint8_t>(line), static_cast<core::LineAction>(i)});
        });
        grid->addWidget(button, at, 3 + static_cast<int>(i));
        row.buttons.push_back(button);
    }
    m_rows.push_back(row);
}

void LinePanel::setColours(PaletteName name) {
    for (const Row& row : m_rows) row.tension->setColours(name);
}

void LinePanel::show(const core::OwnShipView& ship) {
    for (std::size_t i = 0; i < std::min(m_rows.size(), ship.lines.size()); ++i) {
        const core::LineState& line = ship.lines[i];
        const Row& row = m_rows[i];
        const QString text = line.onBollard()
                                 ? tr("%1, %2 m").arg(statusText(line.status)).arg(line.length_m, 0, 'f', 0)
                                 : statusText(line.status);
        if (row.state->text() != text) row.state->setText(text);
        row.tension->setTension(line.tension_N);
        for (QToolButton* button : row.buttons) button->setEnabled(line.onBollard());
        row.buttons[0]->setChecked(line.status == core::LineStatus::Fast);
        row.buttons[1]->setChecked(line.status == core::LineStatus::Slacking);
        row.buttons[2]->setChecked(line.status == core::LineStatus::Heaving);
    }
}

}  // namespace sagara::ui::console
