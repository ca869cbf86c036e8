#include "ui/debrief/TransportBar.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "ui/run/RunTexts.h"
#include "ui/theme/Theme.h"

namespace sagara::ui {

TransportBar::TransportBar(QWidget* parent)
    : QWidget(parent),
      m_rate(new QComboBox(this)),
      m_clock(new QLabel(this)),
      m_place(new QLabel(this)),
      m_source(new QLabel(this)),
      m_note(new QPushButton(tr("Add note"), this)),
      m_sail(new QPushButton(tr("Sail from here"), this)) {
    auto* const layout = new QHBoxLayout(this);
    layout->setContentsMargins(6, 3, 6, 3);
    layout->setSpacing(4);
    m_before = button(QStringLiteral("previous-mark"), {}, QStringLiteral("media-skip-previous-google-f"),
                      tr("To the mark before (Ctrl+Left)"));
    QToolButton* const back10 =
        button(QStringLiteral("back-10"), tr("−10 s"), {}, tr("Ten seconds back (Shift+Left)"));
    QToolButton* const back1 = button(QStringLiteral("back-1"), tr("−1 s"), {}, tr("A second back (Left)"));
    m_play =
        button(QStringLiteral("play"), {}, QStringLiteral("media-play-google"), tr("Play or pause (Space)"));
    QToolButton* const on1 = button(QStringLiteral("on-1"), tr("+1 s"), {}, tr("A second on (Right)"));
    QToolButton* const on10 =
        button(QStringLiteral("on-10"), tr("+10 s"), {}, tr("Ten seconds on (Shift+Right)"));
    m_next = button(QStringLiteral("next-mark"), {}, QStringLiteral("media-skip-next-google-f"),
                    tr("To the next mark (Ctrl+Right)"));
    connect(m_before, &QToolButton::clicked, this, [this] { Q_EMIT markWanted(-1); });
    connect(m_next, &QToolButton::clicked, this, [this] { Q_EMIT markWanted(1); });
    connect(back10, &QToolButton::clicked, this, [this] { Q_EMIT stepWanted(-10.0); });
    connect(back1, &QToolButton::clicked, this, [this] { Q_EMIT stepWanted(-1.0); });
    connect(on1, &QToolButton::clicked, this, [this] { Q_EMIT stepWanted(1.0); });
    connect(on10, &QToolButton::clicked, this, [this] { Q_EMIT stepWanted(10.0); });
    connect(m_play, &QToolButton::clicked, this, &TransportBar::playToggled);

    m_rate->setObjectName(QStringLiteral("replay-rate"));
    m_rate->setToolTip(tr("Pace: seconds of the run in a second of the clock"));
    for (const double rate : {0.25, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0})
        m_rate->addItem(QStringLiteral("%1×").arg(rate), rate);
    m_rate->setCurrentIndex(2);
    connect(m_rate, &QComboBox::currentIndexChanged, this, [this](int index) {
        if (m_replay != nullptr) m_replay->setRate(m_rate->itemData(index).toDouble());
    });
    layout->addWidget(m_rate);
    QFont bold = m_clock->font();
    bold.setBold(true);
    bold.setPointSizeF(1.25 * bold.pointSizeF());
    m_clock->setFont(bold);
    m_clock->setObjectName(QStringLiteral("replay-clock"));
    m_clock->setToolTip(tr("Time since the start of the exercise, of its whole length"));
    m_place->setToolTip(tr("Time of day in the exercise"));
    m_source->setObjectName(QStringLiteral("replay-source"));
    layout->addSpacing(8);
    layout->addWidget(m_clock);
    layout->addSpacing(8);
    layout->addWidget(m_place);
    layout->addSpacing(8);
    layout->addWidget(m_source);
    layout->addStretch(1);
    m_note->setObjectName(QStringLiteral("add-note"));
    m_note->setToolTip(tr("Note something about this moment; it is kept beside the recording (N)"));
    connect(m_note, &QPushButton::clicked, this, &TransportBar::noteWanted);
    m_sail->setObjectName(QStringLiteral("sail-from-here"));
    m_sail->setProperty("primary", true);
    connect(m_sail, &QPushButton::clicked, this, &TransportBar::sailWanted);
    layout->addWidget(m_note);
    layout->addWidget(m_sail);
}

QToolButton* TransportBar::button(const QString& name, const QString& text, const QString& icon,
                                  const QString& tip) {
    auto* const made = new QToolButton(this);
    made->setObjectName(name);
    made->setText(text);
    made->setProperty("icon-name", icon);
    made->setToolTip(tip);
    made->setAccessibleName(tip);
    made->setAutoRaise(true);
    made->setMinimumSize(30, 28);
    if (!icon.isEmpty()) made->setIconSize({22, 22});
    layout()->addWidget(made);
    return made;
}

void TransportBar::setColours(PaletteName name) {
    m_colours = name;
    for (QToolButton* tool : {m_before, m_play, m_next})
        tool->setIcon(themedIcon(tool->property("icon-name").toString(), name));
}

void TransportBar::setReplay(Replay& replay) {
    m_replay = &replay;
    m_replay->setRate(m_rate->currentData().toDouble());
    m_sail->setEnabled(replay.exact());
    m_sail->setToolTip(
        replay.exact()
            ? tr("What if: take the ship at this second and sail on; this recording stays as it is")
            : tr("Only a run of this build of Sagara can be sailed on"));
    refresh(false, false);
}

void TransportBar::refresh(bool sailing, bool exactShown) {
    if (m_replay == nullptr) return;
    const QString icon =
        m_replay->playing() ? QStringLiteral("media-pause-google") : QStringLiteral("media-play-google");
    if (m_play->property("icon-name").toString() != icon) {
        m_play->setProperty("icon-name", icon);
        m_play->setIcon(themedIcon(icon, m_colours));
    }
    m_clock->setText(tr("%1 / %2").arg(elapsed(m_replay->now()), elapsed(m_replay->end())));
    m_place->setText(tr("%1 local").arg(localTime(*m_replay->world(), m_replay->now())));
    if (sailing) return m_source->setText(tr("what if is sailed"));
    if (!m_replay->exact()) {
        m_source->setText(tr("recorded track"));
        m_source->setToolTip(tr("Of another build: the recorded track, five samples a second"));
        return;
    }
    const auto orders = m_replay->orders();
    m_source->setText(exactShown ? tr("exact") : tr("track, exact follows"));
    m_source->setToolTip(orders && orders->verified
                             ? tr("The run is run again to the bit; all of it came out as it was recorded")
                             : tr("The run is run again to the bit"));
}

}  // namespace sagara::ui
