#include "ui/theme/ThemeColours.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

namespace sagara::ui {
namespace {

constexpr double kWords = 4.5;     ///< WCAG 2.1 AA
constexpr double kUnusable = 2.2;  ///< to be seen, not read
constexpr double kEdge = 1.7;      ///< of fields and buttons

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& c) {
    return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

QColor over(const QColor& top, const QColor& below) {
    const auto mix = [&](float a, float b) { return a * top.alphaF() + b * (1.0F - top.alphaF()); };
    return QColor::fromRgbF(mix(top.redF(), below.redF()), mix(top.greenF(), below.greenF()),
                            mix(top.blueF(), below.blueF()));
}

/// Lighter or darker, whichever leads away from what is behind, until it can be read.
QColor readable(QColor words, const QColor& behind, double ratio = kWords) {
    const float step = luminance(behind) < 0.18 ? 0.02F : -0.02F;
    for (int i = 0; i < 50 && contrast(words, behind) < ratio; ++i)
        words.setHslF(std::max(words.hslHueF(), 0.0F), words.hslSaturationF(),
                      std::clamp(words.lightnessF() + step, 0.0F, 1.0F));
    return words;
}

ThemeColours read(const QJsonObject& roles) {
    const auto raw = [&](const char* role) { return QColor(roles[QLatin1String(role)].toString()); };
    ThemeColours c;
    c.window = raw("container-background-color");
    c.surface = raw("container-global-color");
    c.section = raw("container-section-color");
    const auto opaque = [&](const char* role) { return over(raw(role), c.surface); };
    const auto words = [&](const char* role) {
        return readable(readable(readable(opaque(role), c.surface), c.section), c.window);
    };
    c.pressed = opaque("normal-pressed-background-color");
    c.text = words("element-active-color");
    c.quietText = words("element-neutral-color");
    c.disabledText = readable(opaque("element-disabled-color"), c.surface, kUnusable);
    c.line = opaque("border-divider-color");
    c.border = readable(opaque("normal-enabled-border-color"), c.surface, kEdge);
    c.focus = opaque("border-focus-color");
    c.selected = opaque("selected-enabled-background-color");
    c.onSelected = readable(opaque("on-selected-active-color"), c.selected);
    c.setValue = words("instrument-enhanced-primary-color");
    c.accent = words("base-blue-500");
    c.tick = words("instrument-tick-mark-primary-color");
    c.quietTick = opaque("instrument-tick-mark-secondary-color");
    c.port = words("instrument-port-primary-color");
    c.starboard = words("instrument-starboard-primary-color");
    c.alarm = opaque("alert-alarm-color");
    c.warning = opaque("alert-warning-color");
    c.caution = opaque("alert-caution-color");
    c.running = opaque("alert-running-color");
    c.onAlarm = readable(opaque("on-alarm-color"), c.alarm);
    c.onWarning = readable(opaque("on-warning-color"), c.warning);
    c.onCaution = readable(opaque("on-caution-color"), c.caution);
    c.onRunning = readable(opaque("on-running-color"), c.running);
    c.series = {words("data-categorical-01"), words("data-categorical-02"), words("data-categorical-03"),
                words("data-categorical-04")};
    return c;
}

struct Themes {
    std::array<ThemeColours, 3> of;
    Themes() {
        QFile file(QStringLiteral(":/sagara/themes/openbridge.json"));
        if (!file.open(QIODevice::ReadOnly)) qFatal("the palettes are not in this program");
        const QJsonObject themes =
            QJsonDocument::fromJson(file.readAll())[QLatin1String("themes")].toObject();
        of = {read(themes[QLatin1String("day")].toObject()), read(themes[QLatin1String("dusk")].toObject()),
              read(themes[QLatin1String("night")].toObject())};
    }
};

}  // namespace

double contrast(const QColor& a, const QColor& b) {
    const double la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

const ThemeColours& themeColours(PaletteName name) {
    static const Themes themes;
    return themes.of[static_cast<std::size_t>(name)];
}

}  // namespace sagara::ui
