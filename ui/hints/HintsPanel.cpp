#include "ui/hints/HintsPanel.h"

#include <QLabel>
#include <QTimer>
#include <QVBoxLayout>

#include "core/assess/Mission.h"
#include "ui/run/RunTexts.h"
#include "ui/theme/ThemeColours.h"

namespace sagara::ui {
namespace {

constexpr int kLook_ms = 500;
constexpr int kMostLosses = 5;

QLabel* label(QWidget* parent, double scale, bool bold) {
    auto* const made = new QLabel(parent);
    QFont font = made->font();
    font.setPointSizeF(scale * font.pointSizeF());
    font.setBold(bold);
    made->setFont(font);
    made->setWordWrap(true);
    made->setTextFormat(Qt::PlainText);
    return made;
}

}  // namespace

HintsPanel::HintsPanel(ExerciseRun& run, QWidget* parent)
    : QWidget(parent),
      m_run(run),
      m_lines(new QVBoxLayout),
      m_score(label(this, 1.2, true)),
      m_losses(label(this, 1.0, false)) {
    setObjectName(QStringLiteral("hints"));
    setAccessibleName(tr("Hints"));
    m_score->setObjectName(QStringLiteral("hints-score"));
    m_score->setToolTip(tr("Automatic score of 100 points, advisory"));
    m_losses->setObjectName(QStringLiteral("hints-losses"));
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 8, 10, 8);
    layout->setSpacing(2);
    m_lines->setSpacing(2);
    layout->addLayout(m_lines);
    layout->addSpacing(10);
    layout->addWidget(m_score);
    layout->addWidget(m_losses);
    layout->addStretch();
    auto* const look = new QTimer(this);
    connect(look, &QTimer::timeout, this, [this] {
        if (isVisible()) refresh();
    });
    look->start(kLook_ms);
    refresh();
}

void HintsPanel::setColours(PaletteName palette) {
    m_palette = palette;
    refresh();
}

HintsPanel::Row& HintsPanel::row(int index) {
    while (static_cast<int>(m_rows.size()) <= index) {
        Row made{label(this, 0.9, false), label(this, 1.15, true), label(this, 1.0, false)};
        m_lines->addWidget(made.name);
        m_lines->addWidget(made.value);
        m_lines->addWidget(made.detail);
        m_lines->addSpacing(8);
        m_rows.push_back(made);
    }
    return m_rows[static_cast<std::size_t>(index)];
}

void HintsPanel::showLine(int index, const HintLine& line) {
    Row& r = row(index);
    const ThemeColours& colours = themeColours(m_palette);
    const auto set = [](QLabel* label, const QString& text, const QColor& colour) {
        if (label->text() != text) label->setText(text);
        QPalette palette = label->palette();
        palette.setColor(QPalette::WindowText, colour);
        label->setPalette(palette);
        label->setVisible(!text.isEmpty());
    };
    set(r.name, line.name, colours.quietText);
    set(r.value, line.value, colours.text);
    set(r.detail, line.urgent ? tr("⚠ %1").arg(line.detail) : line.detail, colours.text);
    QFont font = r.detail->font();
    font.setBold(line.urgent);
    r.detail->setFont(font);
}

void HintsPanel::refresh() {
    const auto now = m_run.latest();
    const core::World& world = *m_run.world();
    const Hints hints = hintsFor(world, *now, m_run.state().assessment.route);
    const double speed_mps = now->ships.empty() ? 0.0 : core::length(now->ships[0].overGround_mps);
    QVector<HintLine> lines = hintLines(hints, speed_mps);
    if (lines.isEmpty())
        lines.append({tr("Free sailing"), tr("No task and no route"), tr("Sail as you like."), false});
    for (int i = 0; i < lines.size(); ++i) showLine(i, lines[i]);
    for (int i = static_cast<int>(lines.size()); i < static_cast<int>(m_rows.size()); ++i) showLine(i, {});
    m_score->setVisible(!world.mission.criteria.empty());
    m_score->setText(now->failed ? tr("Score %1 of 100, failed").arg(now->score, 0, 'f', 0)
                                 : tr("Score %1 of 100").arg(now->score, 0, 'f', 0));
    showLosses();
}

void HintsPanel::showLosses() {
    for (const core::Event& event : m_run.eventsFrom(m_eventsSeen)) {
        ++m_eventsSeen;
        if (event.kind == core::EventKind::Deduction && event.points > 0.0)
            m_lossLines.append(tr("%1  %2").arg(elapsed(event.time()), eventText(*m_run.world(), event)));
        while (m_lossLines.size() > kMostLosses) m_lossLines.removeFirst();
    }
    m_losses->setVisible(!m_lossLines.isEmpty());
    m_losses->setText(m_lossLines.join(QLatin1Char('\n')));
}

}  // namespace sagara::ui
