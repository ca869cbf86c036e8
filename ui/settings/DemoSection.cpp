#include "ui/settings/DemoSection.h"

#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include "ui/settings/StoredSettings.h"

namespace sagara::ui {

DemoSection::DemoSection(SettingsStore& store, QWidget* parent)
    : Section(tr("Exhibition"), QStringLiteral("view-gallery-google"), parent),
      m_store(store),
      m_pin(new QLineEdit(storedPin(store), this)),
      m_pinTrouble(complaint("demo-pin-trouble")),
      m_chord(new QKeySequenceEdit(storedChord(store), this)),
      m_chordTrouble(complaint("demo-chord-trouble")),
      m_usual(complaint("demo-usual")) {
    m_pin->setObjectName(QStringLiteral("demo-pin"));
    m_pin->setMaxLength(kLongestPin);
    m_pin->setMaximumWidth(140);
    m_pin->setToolTip(tr("Asked for after the keys: %1 to %2 digits").arg(kShortestPin).arg(kLongestPin));
    m_chord->setObjectName(QStringLiteral("demo-chord"));
    m_chord->setMaximumWidth(220);
    m_chord->setToolTip(tr("One key with at least two of Ctrl, Alt and Shift"));
    auto* const usual = new QPushButton(tr("Back to usual"), this);
    usual->setObjectName(QStringLiteral("demo-back-to-usual"));
    usual->setToolTip(tr("Ctrl+Shift+Q and %1").arg(QString::fromLatin1(kUsualDemoPin)));

    auto* const group = new QGroupBox(tr("Leaving the exhibition"), this);
    auto* const form = new QFormLayout(group);
    form->addRow(tr("Keys"), m_chord);
    form->addRow(m_chordTrouble);
    form->addRow(tr("PIN"), m_pin);
    form->addRow(m_pinTrouble);
    form->addRow(m_usual);
    auto* const row = new QHBoxLayout;  // a form would stretch it
    row->addWidget(usual);
    row->addStretch();
    form->addRow(row);
    auto* const layout = new QVBoxLayout(this);
    layout->addWidget(
        note(tr("An exhibition fills the screen and cannot be closed by visitors. To leave it, "
                "press the keys together, then enter the PIN. The PIN keeps children from the "
                "desktop; it is stored as it stands and protects nothing else.")));
    layout->addWidget(group);
    layout->addStretch();

    connect(m_pin, &QLineEdit::textEdited, this, &DemoSection::takePin);
    connect(m_chord, &QKeySequenceEdit::keySequenceChanged, this, &DemoSection::takeChord);
    connect(usual, &QPushButton::clicked, this, [this] {
        m_pin->setText(QString::fromLatin1(kUsualDemoPin));
        takePin();
        m_chord->setKeySequence(usualDemoChord());
    });
    tell();
}

void DemoSection::tell() {
    say(m_usual, storedPin(m_store) == QLatin1String(kUsualDemoPin)
                     ? tr("The PIN is 0000, as in every new installation: change it before an exhibition.")
                     : QString());
}

void DemoSection::takePin() {
    const bool right = isPin(m_pin->text());
    say(m_pinTrouble, right ? QString()
                            : tr("Not stored: a PIN is %1 to %2 digits, 0 to 9. The PIN is still %3.")
                                  .arg(kShortestPin)
                                  .arg(kLongestPin)
                                  .arg(storedPin(m_store)));
    if (right) storePin(m_store, m_pin->text());
    tell();
}

void DemoSection::takeChord() {
    const QKeySequence pressed = m_chord->keySequence();
    if (pressed.isEmpty()) return;
    const QKeySequence chord(pressed[0]);
    const bool right = isChord(chord);
    say(m_chordTrouble, right ? QString()
                              : tr("%1 is not accepted: one key with at least two of Ctrl, Alt and Shift.")
                                    .arg(chord.toString(QKeySequence::NativeText)));
    if (right) storeChord(m_store, chord);
    const QSignalBlocker quiet(m_chord);
    m_chord->setKeySequence(storedChord(m_store));
}

}  // namespace sagara::ui
