#include "ui/trainee/RadarColours.h"

#include <algorithm>
#include <cmath>

namespace sagara::ui::console {

const RadarColours& radarColours(PaletteName name) {
    static const RadarColours day{{0x0b, 0x16, 0x22}, {0x10, 0x24, 0x3a}, {0xff, 0xdc, 0x4a},
                                  {0x3d, 0x64, 0x80}, {0xb8, 0xd4, 0xe4}, {0x5d, 0xc8, 0x8c},
                                  {0xff, 0x9d, 0x5c}};
    static const RadarColours dusk{{0x08, 0x0f, 0x18}, {0x0a, 0x18, 0x28}, {0xe6, 0xc0, 0x3c},
                                   {0x2c, 0x4a, 0x60}, {0x92, 0xac, 0xbc}, {0x3c, 0x8c, 0x60},
                                   {0xd8, 0x80, 0x48}};
    static const RadarColours night{{0x03, 0x05, 0x08}, {0x04, 0x08, 0x0e}, {0xa0, 0x84, 0x24},
                                    {0x1a, 0x2c, 0x3a}, {0x6c, 0x80, 0x8c}, {0x20, 0x52, 0x38},
                                    {0xa0, 0x5c, 0x30}};
    return name == PaletteName::Day ? day : name == PaletteName::Dusk ? dusk : night;
}

RadarPalette::RadarPalette(const RadarColours& c, double gain) : m_shades(kShades) {
    // Gain 1 shows all there is, gain 0 only what saturates.
    const double least = 200.0 * (1.0 - gain);
    for (std::size_t s = 0; s < kShades; ++s) {
        const double bright = static_cast<double>(s + 1) / static_cast<double>(kShades);
        for (std::size_t level = 0; level < 256; ++level) {
            const double part =
                level == 0
                    ? 0.0
                    : bright *
                          std::clamp((static_cast<double>(level) - least) / (1.05 * (255.0 - least)) + 0.05,
                                     0.0, 1.0);
            const auto mix = [&](int a, int b) { return static_cast<int>(std::lround(a + part * (b - a))); };
            m_shades[s][level] = qRgb(mix(c.water.red(), c.echo.red()), mix(c.water.green(), c.echo.green()),
                                      mix(c.water.blue(), c.echo.blue()));
        }
    }
}

const QRgb* RadarPalette::shade(double brightness) const {
    const auto at =
        static_cast<std::size_t>(std::clamp(brightness, 0.0, 1.0) * static_cast<double>(kShades - 1));
    return m_shades[at].data();
}

}  // namespace sagara::ui::console
