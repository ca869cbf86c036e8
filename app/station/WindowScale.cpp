#include "app/station/WindowScale.h"

#include <QGuiApplication>
#include <QScreen>
#include <algorithm>
#include <cmath>

#include "app/station/SettingsDoor.h"
#include "ui/settings/StoredSettings.h"

namespace sagara::station {
namespace {

constexpr const char* kScale = "QT_SCALE_FACTOR";

double scaleOfFirstMonitor(int argc, char** argv) {
    const QGuiApplication ask(argc, argv);
    const QScreen* const screen = QGuiApplication::primaryScreen();
    if (screen == nullptr) return 1.0;
    return monitorScale(screen->size(), screen->devicePixelRatio(), screen->logicalDotsPerInch());
}

}  // namespace

double monitorScale(QSize screen_px, double devicePixelRatio, double logicalDpi) {
    constexpr double kScaledByDesktop_dpi = 110.0;
    constexpr double kUsual_px = 1080.0;
    if (devicePixelRatio > 1.0 || logicalDpi > kScaledByDesktop_dpi) return 1.0;
    const double side_px = std::min(screen_px.width() * 9.0 / 16.0, 1.0 * screen_px.height());
    const double halves = std::floor(2.0 * side_px / kUsual_px) / 2.0;
    return std::clamp(halves, 1.0, 4.0);
}

void scaleWindows(run::Store& store, bool hasDisplay, int argc, char** argv) {
    for (const char* name : {kScale, "QT_SCREEN_SCALE_FACTORS", "QT_FONT_DPI"})
        if (qEnvironmentVariableIsSet(name)) return;
    const auto chosen = ui::storedSize_percent(*settingsStore(store));
    double scale = 1.0;
    if (chosen)
        scale = 0.01 * *chosen;
    else if (hasDisplay)
        scale = scaleOfFirstMonitor(argc, argv);
    if (scale != 1.0) qputenv(kScale, QByteArray::number(scale));
}

}  // namespace sagara::station
