#pragma once

#include <QColor>
#include <QRgb>
#include <array>
#include <vector>

#include "ui/theme/PaletteName.h"

namespace sagara::ui::console {

/// A radar screen is dark at any hour; by night it is dimmer.
struct RadarColours {
    QColor surround;  ///< round the screen
    QColor water;     ///< no echo
    QColor echo;      ///< saturated
    QColor ring;
    QColor scale;
    QColor sweep;
    QColor tool;
};
const RadarColours& radarColours(PaletteName name);

/// Colours of echoes by level for some ages. Made for every picture: the gain may have changed.
class RadarPalette {
public:
    RadarPalette(const RadarColours& colours, double gain);
    /// 256 colours for a brightness of 0 to 1.
    const QRgb* shade(double brightness) const;

private:
    static constexpr std::size_t kShades = 24;
    std::vector<std::array<QRgb, 256>> m_shades;
};

}  // namespace sagara::ui::console
