#pragma once

#include <QKeySequence>
#include <array>
#include <optional>

#include "ui/input/BridgeInput.h"
#include "ui/settings/SettingsStore.h"
#include "ui/sound/SoundBoard.h"
#include "ui/theme/PaletteName.h"

/// What the settings hold and under which keys; nothing else reads or writes them but the exhibition, which
/// reads demo.pin and demo.chord.
namespace sagara::ui {

PaletteName storedPalette(const SettingsStore& store);
void storePalette(SettingsStore& store, PaletteName palette);

/// How large text and controls are, in percent of the usual; none: as the monitor asks for. Holds from the
/// next start on, for Qt wants it before the first window.
inline constexpr std::array kSizes_percent{100, 125, 150, 175, 200, 250, 300};
std::optional<int> storedSize_percent(const SettingsStore& store);
void storeSize_percent(SettingsStore& store, std::optional<int> percent);

/// Once at the start of the program: controls, keys, NMEA, mute and volume as they were left.
void applySettings(const SettingsStore& store, BridgeInput& input, SoundBoard& sound);

void storeSound(SettingsStore& store, const SoundBoard& sound);
void storeKeys(SettingsStore& store, const KeyMap& keys);
void storeMap(SettingsStore& store, const std::string& model, const ControlMap& map);
void storeNmea(SettingsStore& store, const NmeaSettings& settings);

inline constexpr const char* kUsualDemoPin = "0000";
inline constexpr int kShortestPin = 4;
inline constexpr int kLongestPin = 8;
/// Digits only, of such a length.
bool isPin(const QString& text);
QString storedPin(const SettingsStore& store);
void storePin(SettingsStore& store, const QString& pin);

QKeySequence usualDemoChord();  ///< Ctrl+Shift+Q
/// One key with at least two of Ctrl, Alt, Shift: no child on an exhibition presses it by chance.
bool isChord(const QKeySequence& keys);
QKeySequence storedChord(const SettingsStore& store);
void storeChord(SettingsStore& store, const QKeySequence& chord);

}  // namespace sagara::ui
