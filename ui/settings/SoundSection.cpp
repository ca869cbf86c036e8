#include "ui/settings/SoundSection.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

#include "ui/settings/StoredSettings.h"

namespace sagara::ui {

SoundSection::SoundSection(SettingsStore& store, SoundBoard& sound, QWidget* parent)
    : Section(tr("Sound"), QStringLiteral("sound"), parent),
      m_store(store),
      m_sound(sound),
      m_device(new QLabel(this)),
      m_again(new QPushButton(tr("Look again"), this)),
      m_test(new QPushButton(tr("Sound the horn"), this)),
      m_muted(new QCheckBox(tr("Mute"), this)),
      m_volume(new QSlider(Qt::Horizontal, this)),
      m_percent(new QLabel(this)) {
    m_device->setObjectName(QStringLiteral("sound-device"));
    m_device->setWordWrap(true);
    m_again->setObjectName(QStringLiteral("sound-again"));
    m_again->setToolTip(tr("After loudspeakers or headphones were plugged in"));
    m_test->setObjectName(QStringLiteral("sound-test"));
    m_test->setToolTip(tr("About one second of the ship's whistle"));
    m_muted->setObjectName(QStringLiteral("sound-muted"));
    m_muted->setToolTip(tr("Nothing is heard, alarms neither"));
    m_volume->setObjectName(QStringLiteral("sound-volume"));
    m_volume->setRange(0, 100);
    m_volume->setPageStep(10);
    m_volume->setMinimumWidth(260);
    m_volume->setToolTip(tr("Volume of everything, 0 to 100 %"));
    m_percent->setMinimumWidth(48);

    auto* const device = new QGroupBox(tr("Device"), this);
    auto* const found = new QHBoxLayout(device);
    found->addWidget(m_device, 1);
    found->addWidget(m_again);
    found->addWidget(m_test);
    auto* const level = new QGroupBox(tr("Level"), this);
    auto* const form = new QFormLayout(level);
    auto* const row = new QHBoxLayout;
    row->addWidget(m_volume);
    row->addWidget(m_percent);
    row->addStretch();
    form->addRow(tr("Volume"), row);
    form->addRow(QString(), m_muted);
    auto* const layout = new QVBoxLayout(this);
    layout->addWidget(device);
    layout->addWidget(level);
    layout->addWidget(
        note(tr("Heard on the bridge: engines by their revolutions, propeller wash, bow wave by "
                "speed, wind over the deck, rain, whistle, bell, anchor cable and alarm, each "
                "from where it is. In restricted visibility other vessels sound their signals "
                "(COLREG rule 35), the later the farther away they are.")));
    layout->addStretch();

    m_volume->setValue(static_cast<int>(std::lround(100.0 * sound.volume())));
    m_muted->setChecked(sound.muted());
    connect(m_volume, &QSlider::valueChanged, this, &SoundSection::take);
    connect(m_volume, &QSlider::sliderReleased, this, &SoundSection::take);  // kept once, not at every step
    connect(m_muted, &QCheckBox::toggled, this, &SoundSection::take);
    connect(m_again, &QPushButton::clicked, this, [this] { m_sound.lookAgain(); });
    connect(m_test, &QPushButton::clicked, this, [this] { m_sound.soundTest(); });
    refresh();
}

void SoundSection::take() {
    m_sound.setVolume(0.01 * m_volume->value());
    m_sound.setMuted(m_muted->isChecked());
    if (!m_volume->isSliderDown()) storeSound(m_store, m_sound);
    refresh();
}

void SoundSection::refresh() {
    const SoundBoard::Status status = m_sound.status();
    const bool found = status.device == SoundBoard::Device::Found;
    const bool looking = status.device == SoundBoard::Device::Looking;
    const QString text = found     ? QString::fromStdString(status.name)
                         : looking ? tr("Looking for a sound device …")
                                   : tr("No sound device. Everything works, silently. Plug in loudspeakers "
                                        "or headphones and look again.");
    if (m_device->text() != text) m_device->setText(text);
    m_again->setVisible(!found);
    m_again->setEnabled(!looking);
    m_test->setEnabled(found && !m_sound.muted());
    const QString percent = tr("%1 %").arg(m_volume->value());
    if (m_percent->text() != percent) m_percent->setText(percent);
}

}  // namespace sagara::ui
