#pragma once

#include <array>
#include <functional>

#include "ui/settings/Section.h"
#include "ui/settings/SettingsStore.h"

class QPushButton;

namespace sagara::ui {

/// Day, dusk or night; how large everything is.
class DisplaySection final : public Section {
    Q_OBJECT

public:
    DisplaySection(SettingsStore& store, std::function<void(PaletteName)> setPalette, QWidget* parent);
    void setColours(PaletteName palette) override;

private:
    void choose(PaletteName palette);
    QWidget* sizeGroup();
    SettingsStore& m_store;
    std::function<void(PaletteName)> m_setPalette;
    std::array<QPushButton*, 3> m_choices{};
};

}  // namespace sagara::ui
