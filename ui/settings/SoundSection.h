#pragma once

#include "ui/settings/Section.h"
#include "ui/settings/SettingsStore.h"
#include "ui/sound/SoundBoard.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSlider;

namespace sagara::ui {

/// Mute, volume, and whether there is a device at all.
class SoundSection final : public Section {
    Q_OBJECT

public:
    SoundSection(SettingsStore& store, SoundBoard& sound, QWidget* parent);
    void refresh() override;

private:
    void take();
    SettingsStore& m_store;
    SoundBoard& m_sound;
    QLabel* m_device;
    QPushButton* m_again;
    QPushButton* m_test;
    QCheckBox* m_muted;
    QSlider* m_volume;
    QLabel* m_percent;
};

}  // namespace sagara::ui
