#include "ui/settings/StoredSettings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

namespace sagara::ui {
namespace {

constexpr std::string_view kPalette = "display.palette";
constexpr std::string_view kSize = "display.size_percent";
constexpr std::string_view kMuted = "sound.muted";
constexpr std::string_view kVolume = "sound.volume_percent";
constexpr std::string_view kKeys = "input.keys";
constexpr std::string_view kDevices = "input.devices";  ///< models with a map, separated by blanks
constexpr std::string_view kDevice = "input.device.";   ///< and the model
constexpr std::string_view kNmea = "input.nmea";
constexpr std::string_view kPin = "demo.pin";
constexpr std::string_view kChord = "demo.chord";

constexpr std::array<std::string_view, 3> kPalettes{"day", "dusk", "night"};

std::vector<std::string> words(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> all;
    for (std::string word; in >> word;) all.push_back(word);
    return all;
}

std::string keyOf(const std::string& model) { return std::string(kDevice).append(model); }

}  // namespace

PaletteName storedPalette(const SettingsStore& store) {
    const auto name = store.get(kPalette);
    for (std::size_t i = 0; i < kPalettes.size(); ++i)
        if (name == kPalettes[i]) return static_cast<PaletteName>(i);
    return PaletteName::Day;
}

void storePalette(SettingsStore& store, PaletteName palette) {
    store.put(kPalette, kPalettes[static_cast<std::size_t>(palette)]);
}

std::optional<int> storedSize_percent(const SettingsStore& store) {
    const auto text = store.get(kSize);
    for (const int percent : kSizes_percent)
        if (text == std::to_string(percent)) return percent;
    return std::nullopt;
}

void storeSize_percent(SettingsStore& store, std::optional<int> percent) {
    store.put(kSize, percent ? std::to_string(*percent) : "automatic");
}

void applySettings(const SettingsStore& store, BridgeInput& input, SoundBoard& sound) {
    sound.setMuted(store.get(kMuted) == "1");
    if (const auto text = store.get(kVolume)) {
        int percent = 0;
        const char* const end = text->data() + text->size();
        if (std::from_chars(text->data(), end, percent).ptr == end && percent >= 0 && percent <= 100)
            sound.setVolume(0.01 * percent);
    }
    if (const auto text = store.get(kKeys)) input.setKeys(keyMapOf(*text));
    for (const std::string& model : words(store.get(kDevices).value_or(""))) {
        const auto text = store.get(keyOf(model));
        const auto map = text ? controlMapOf(*text) : std::nullopt;
        if (map) input.setMap(model, *map);
    }
    if (const auto text = store.get(kNmea)) input.nmea().open(nmeaSettingsOf(*text));
}

void storeSound(SettingsStore& store, const SoundBoard& sound) {
    store.put(kMuted, sound.muted() ? "1" : "0");
    store.put(kVolume, std::to_string(static_cast<int>(100.0 * sound.volume() + 0.5)));
}

void storeKeys(SettingsStore& store, const KeyMap& keys) { store.put(kKeys, textOf(keys)); }

void storeMap(SettingsStore& store, const std::string& model, const ControlMap& map) {
    std::string models = store.get(kDevices).value_or("");
    const auto known = words(models);
    if (std::find(known.begin(), known.end(), model) == known.end())
        store.put(kDevices, models.append(models.empty() ? "" : " ").append(model));
    store.put(keyOf(model), textOf(map));
}

void storeNmea(SettingsStore& store, const NmeaSettings& settings) { store.put(kNmea, textOf(settings)); }

bool isPin(const QString& text) {
    return text.size() >= kShortestPin && text.size() <= kLongestPin &&
           std::all_of(text.begin(), text.end(),
                       [](QChar c) { return c >= QLatin1Char('0') && c <= QLatin1Char('9'); });
}

QString storedPin(const SettingsStore& store) {
    const QString pin = QString::fromStdString(store.get(kPin).value_or(kUsualDemoPin));
    return isPin(pin) ? pin : QString::fromLatin1(kUsualDemoPin);
}

void storePin(SettingsStore& store, const QString& pin) { store.put(kPin, pin.toStdString()); }

QKeySequence usualDemoChord() { return QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Q); }

bool isChord(const QKeySequence& keys) {
    if (keys.count() != 1) return false;
    const auto with = keys[0].keyboardModifiers();
    const int held = (with.testFlag(Qt::ControlModifier) ? 1 : 0) + (with.testFlag(Qt::AltModifier) ? 1 : 0) +
                     (with.testFlag(Qt::ShiftModifier) ? 1 : 0);
    return held >= 2;
}

QKeySequence storedChord(const SettingsStore& store) {
    const QKeySequence chord(QString::fromStdString(store.get(kChord).value_or("")),
                             QKeySequence::PortableText);
    return isChord(chord) ? chord : usualDemoChord();
}

void storeChord(SettingsStore& store, const QKeySequence& chord) {
    store.put(kChord, chord.toString(QKeySequence::PortableText).toStdString());
}

}  // namespace sagara::ui
