#include "ui/settings/KeyboardSection.h"

#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

#include "ui/settings/StoredSettings.h"

namespace sagara::ui {

KeyboardSection::KeyboardSection(SettingsStore& store, BridgeInput& input, QWidget* parent)
    : Section(tr("Keyboard"), QStringLiteral("command-autopilot"), parent),
      m_store(store),
      m_input(input),
      m_trouble(complaint("keys-trouble")) {
    using enum BridgeAction;
    auto* const grid = new QGridLayout;
    grid->addWidget(
        group(tr("Steering"), {RudderPort, RudderStarboard, RudderPortFine, RudderStarboardFine, Midships}),
        0, 0);
    grid->addWidget(group(tr("Engines"), {TelegraphUp, TelegraphDown, StopEngines}), 1, 0);
    grid->addWidget(group(tr("Thrusters"), {ThrusterPort, ThrusterStop, ThrusterStarboard, SternThrusterPort,
                                            SternThrusterStop, SternThrusterStarboard}),
                    1, 1);
    grid->addWidget(group(tr("Look and signals"), {LookLeft, LookRight, Horn, Acknowledge, Bookmark}), 0, 1);
    auto* const usual = new QPushButton(tr("Back to usual keys"), this);
    usual->setObjectName(QStringLiteral("usual-keys"));
    usual->setToolTip(tr("Give every action the key it had when Sagara was installed"));
    auto* const layout = new QVBoxLayout(this);
    layout->addWidget(
        note(tr("Click a field and press the key, with or without Ctrl, Alt, Shift. Keys act "
                "while the bridge is the window in front; fields for text keep theirs.")));
    layout->addLayout(grid);
    layout->addWidget(m_trouble);
    layout->addWidget(usual, 0, Qt::AlignLeft);
    layout->addStretch();
    connect(usual, &QPushButton::clicked, this, [this] {
        keep(usualKeys());
        say(m_trouble, {});
        showKeys();
    });
    showKeys();
}

QWidget* KeyboardSection::group(const QString& title, std::initializer_list<BridgeAction> actions) {
    auto* const box = new QGroupBox(title, this);
    auto* const form = new QFormLayout(box);
    for (const BridgeAction action : actions) {
        auto* const field = new QKeySequenceEdit(box);
        field->setObjectName(QStringLiteral("key-%1").arg(QString::fromLatin1(actionName(action))));
        field->setToolTip(tr("The key for: %1. Click and press it.").arg(actionText(action)));
        auto* const clear = new QToolButton(box);
        clear->setText(tr("✕"));
        clear->setObjectName(QStringLiteral("clear-%1").arg(QString::fromLatin1(actionName(action))));
        clear->setToolTip(tr("No key for: %1").arg(actionText(action)));
        clear->setAccessibleName(clear->toolTip());
        clear->setFocusPolicy(Qt::StrongFocus);
        connect(clear, &QToolButton::clicked, field, &QKeySequenceEdit::clear);
        auto* const row = new QHBoxLayout;
        row->addWidget(field);
        row->addWidget(clear);
        form->addRow(actionText(action), row);
        m_fields[action] = field;
        connect(field, &QKeySequenceEdit::keySequenceChanged, this, [this, action] { take(action); });
    }
    return box;
}

void KeyboardSection::showKeys() {
    for (const KeyEntry& entry : m_input.keys()) {
        const auto field = m_fields.find(entry.action);
        if (field == m_fields.end()) continue;
        const QSignalBlocker quiet(field->second);
        field->second->setKeySequence(entry.key);
    }
}

void KeyboardSection::keep(const KeyMap& keys) {
    m_input.setKeys(keys);
    storeKeys(m_store, keys);
}

void KeyboardSection::take(BridgeAction action) {
    QKeySequenceEdit* const field = m_fields.at(action);
    const QKeySequence pressed = field->keySequence();
    // One press is a key; the field would wait for three more.
    const QKeySequence key = pressed.isEmpty() ? pressed : QKeySequence(pressed[0]);
    KeyMap keys = m_input.keys();
    const auto holder = holderOf(keys, key);
    if (holder && *holder != action) {
        say(m_trouble, tr("%1 already does: %2. Take it away there first, or press another key.")
                           .arg(key.toString(QKeySequence::NativeText), actionText(*holder)));
        showKeys();
        return;
    }
    for (KeyEntry& entry : keys)
        if (entry.action == action) entry.key = key;
    say(m_trouble, {});
    keep(keys);
    const QSignalBlocker quiet(field);
    field->setKeySequence(key);
}

}  // namespace sagara::ui
