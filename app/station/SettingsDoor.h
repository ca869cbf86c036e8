#pragma once

#include <functional>
#include <memory>

#include "app/run/Store.h"
#include "ui/input/BridgeInput.h"
#include "ui/settings/SettingsStore.h"
#include "ui/settings/StoredSettings.h"
#include "ui/sound/SoundBoard.h"
#include "ui/theme/Page.h"

namespace sagara::station {

class Frame;

/// Settings in the database, or for as long as the program runs where there is none (or it goes away). At the
/// start of the program: ui::applySettings(*settingsStore(store), input, sound).
std::unique_ptr<ui::SettingsStore> settingsStore(run::Store& store);
std::unique_ptr<ui::SettingsStore> settingsStore(Frame& frame);

/// `input` and `sound` outlive the page. `setPalette` changes the colours of the whole program.
ui::Page* settingsPage(Frame& frame, ui::BridgeInput& input, ui::SoundBoard& sound,
                       std::function<void(ui::PaletteName)> setPalette);

}  // namespace sagara::station
