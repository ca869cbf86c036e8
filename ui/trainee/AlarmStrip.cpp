#include "ui/trainee/AlarmStrip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStringList>

#include "ui/theme/Theme.h"

namespace sagara::ui::console {

AlarmStrip::AlarmStrip(QWidget* parent)
    : QWidget(parent), m_text(new QLabel(this)), m_acknowledge(new QPushButton(tr("Acknowledge"), this)) {
    m_text->setObjectName(QStringLiteral("alarms"));
    m_text->setTextFormat(Qt::PlainText);
    m_text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_acknowledge->setObjectName(QStringLiteral("acknowledge"));
    m_acknowledge->setToolTip(tr("Silences the alarms; each stays in sight until its cause is gone (A)"));
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_text, 1);
    row->addWidget(m_acknowledge);
    connect(m_acknowledge, &QPushButton::clicked, this, &AlarmStrip::acknowledge);
    refresh();
}

void AlarmStrip::setColours(PaletteName name) {
    m_palette = name;
    refresh();
}

void AlarmStrip::update(const AlarmInputs& now) {
    m_alarms.update(now);
    refresh();
}

void AlarmStrip::acknowledge() {
    m_alarms.acknowledgeAll();
    refresh();
}

void AlarmStrip::refresh() {
    QStringList texts;
    for (const Alarm& alarm : m_alarms.list())
        texts << (alarm.active ? alarm.text : tr("%1 (passed)").arg(alarm.text));
    const bool sounds = m_alarms.sounding();
    const ThemeColours& c = themeColours(m_palette);
    const QColor back = texts.isEmpty() ? c.surface : sounds ? c.alarm : c.section;
    const QColor ink = texts.isEmpty() ? c.quietText : sounds ? c.onAlarm : c.text;
    const QString words = texts.isEmpty() ? tr("No alarms") : texts.join(QStringLiteral("   ·   "));
    const QString style = QStringLiteral(
                              "QLabel { background: %1; color: %2; padding: 3px 10px; border-radius: 4px; "
                              "font-weight: bold; border: 1px solid %3; }")
                              .arg(back.name(), ink.name(), texts.isEmpty() ? c.line.name() : c.alarm.name());
    if (m_text->text() != words) m_text->setText(words);
    if (m_text->toolTip() != words) m_text->setToolTip(words);
    if (m_text->styleSheet() != style) m_text->setStyleSheet(style);
    m_acknowledge->setEnabled(sounds);
    if (sounds == m_sounding) return;
    m_sounding = sounds;
    Q_EMIT sounding(sounds);
}

}  // namespace sagara::ui::console
