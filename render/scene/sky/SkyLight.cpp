#include "render/scene/sky/SkyLight.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::render {
namespace {

/// Colours at one height of the sun, chosen by eye; between two they are mixed.
struct Hour {
    double sunAltitude_deg;
    Colour zenith, horizon, glow, sun, sky;
};
constexpr std::array<Hour, 8> kHours{{
    {-18.0,
     {0.022, 0.034, 0.070},
     {0.055, 0.066, 0.10},
     {0.0, 0.0, 0.0},
     {0.0, 0.0, 0.0},
     {0.09, 0.10, 0.14}},
    {-12.0,
     {0.028, 0.044, 0.10},
     {0.10, 0.10, 0.135},
     {0.06, 0.025, 0.01},
     {0.0, 0.0, 0.0},
     {0.10, 0.108, 0.155}},
    {-6.0, {0.05, 0.085, 0.21}, {0.36, 0.25, 0.24}, {0.42, 0.19, 0.06}, {0.0, 0.0, 0.0}, {0.15, 0.16, 0.23}},
    {-1.0,
     {0.15, 0.25, 0.47},
     {0.70, 0.50, 0.39},
     {0.60, 0.30, 0.10},
     {0.05, 0.02, 0.01},
     {0.32, 0.32, 0.38}},
    {5.0, {0.22, 0.39, 0.66}, {0.80, 0.70, 0.60}, {0.50, 0.32, 0.15}, {0.80, 0.52, 0.28}, {0.37, 0.39, 0.45}},
    {15.0,
     {0.21, 0.42, 0.74},
     {0.74, 0.79, 0.84},
     {0.30, 0.25, 0.18},
     {0.82, 0.72, 0.58},
     {0.40, 0.44, 0.51}},
    {40.0,
     {0.17, 0.38, 0.72},
     {0.70, 0.79, 0.88},
     {0.22, 0.20, 0.17},
     {0.80, 0.77, 0.71},
     {0.42, 0.47, 0.54}},
    {90.0,
     {0.15, 0.36, 0.71},
     {0.69, 0.79, 0.89},
     {0.20, 0.19, 0.17},
     {0.80, 0.78, 0.74},
     {0.43, 0.48, 0.55}},
}};

Colour mixed(const Colour& a, const Colour& b, double f) {
    return {a[0] + (b[0] - a[0]) * f, a[1] + (b[1] - a[1]) * f, a[2] + (b[2] - a[2]) * f};
}
Colour scaled(const Colour& a, double f) { return {a[0] * f, a[1] * f, a[2] * f}; }
double brightness(const Colour& a) { return 0.3 * a[0] + 0.59 * a[1] + 0.11 * a[2]; }

Hour hourOf(double altitude_deg) {
    if (altitude_deg <= kHours.front().sunAltitude_deg) return kHours.front();
    std::size_t n = 1;
    while (n + 1 < kHours.size() && kHours[n].sunAltitude_deg < altitude_deg) ++n;
    const Hour &a = kHours[n - 1], &b = kHours[n];
    const double f =
        std::min(1.0, (altitude_deg - a.sunAltitude_deg) / (b.sunAltitude_deg - a.sunAltitude_deg));
    return {altitude_deg,
            mixed(a.zenith, b.zenith, f),
            mixed(a.horizon, b.horizon, f),
            mixed(a.glow, b.glow, f),
            mixed(a.sun, b.sun, f),
            mixed(a.sky, b.sky, f)};
}

}  // namespace

double extinctionOf(double visibility_m) { return 3.912 / std::max(20.0, visibility_m); }

SkyLight skyLight(const core::World& world, const Moment& moment) {
    const core::GeoPoint place = world.area.frame.datum();
    const SkyTime time = SkyTime::of(world.start, moment.time.seconds());
    SkyLight light;
    light.sun = sunSeen(place, time);
    light.moon = moonSeen(place, time);
    const double altitude_deg = light.sun.altitude_rad / core::kDegree_rad;
    const Hour hour = hourOf(altitude_deg);
    light.night = std::clamp((-2.0 - altitude_deg) / 10.0, 0.0, 1.0);
    light.rain = std::clamp(moment.weather.rain, 0.0, 1.0);
    light.extinction_perM = extinctionOf(moment.weather.visibility_m);

    // Fair-weather clouds, more with wind, a closed cover with rain or in fog.
    const double fog = std::clamp(1.0 - moment.weather.visibility_m / 4000.0, 0.0, 1.0);
    light.cloudCover = std::max({0.30 + 0.012 * moment.wind.speed_mps, 0.55 + 0.45 * light.rain * 1.5, fog});
    if (light.rain <= 0.0) light.cloudCover = std::max(0.30 + 0.012 * moment.wind.speed_mps, fog);
    light.cloudCover = std::min(1.0, light.cloudCover);
    const double grey = std::clamp((light.cloudCover - 0.55) / 0.45, 0.0, 1.0);

    const double dim = 1.0 - 0.35 * grey;
    const auto covered = [&](const Colour& c) {
        const double b = brightness(c) * dim;
        return mixed(c, {0.97 * b, 1.0 * b, 1.04 * b}, grey);
    };
    light.horizon = covered(hour.horizon);
    light.zenith = mixed(covered(hour.zenith), scaled(light.horizon, 0.85), 0.7 * grey);
    light.glow = scaled(hour.glow, 1.0 - 0.9 * grey);
    light.sunColour = scaled(hour.sun, 1.0 - 0.95 * grey);
    light.skyColour = mixed(covered(hour.sky), scaled(light.horizon, 0.8), 0.6 * grey);
    const double moonUp = std::clamp(light.moon.seen.altitude_rad / 0.1, 0.0, 1.0);
    light.lowLight =
        scaled({0.10, 0.115, 0.14}, light.moon.litShare * moonUp * light.night * (1.0 - 0.9 * grey));
    light.skyColour =
        mixed(light.skyColour,
              {light.skyColour[0] + 0.2 * light.lowLight[0], light.skyColour[1] + 0.2 * light.lowLight[1],
               light.skyColour[2] + 0.2 * light.lowLight[2]},
              1.0);
    return light;
}

}  // namespace sagara::render
