#pragma once

#include <array>

#include "core/exercise/World.h"
#include "render/scene/Moment.h"
#include "render/scene/sky/Almanac.h"

namespace sagara::render {

/// Red, green, blue as the screen gets them.
using Colour = std::array<double, 3>;

/// Light of one moment: what every shader needs to know of sky and air.
struct SkyLight {
    Horizontal sun;
    Moon moon;
    Colour zenith, horizon, glow;  ///< of the clear or covered sky; glow stands around the sun
    Colour sunColour;              ///< of direct light on a white surface
    Colour skyColour;              ///< of all the rest
    Colour lowLight;               ///< direct light of the moon
    double night = 0.0;            ///< 0 by day, 1 when it is as dark as it gets
    double cloudCover = 0.0;       ///< 0 to 1
    double extinction_perM = 0.0;  ///< of the air: what is left after d metres is exp(-extinction d)
    double rain = 0.0;
};

/// 2 % of contrast are left at the visibility (Koschmieder 1924).
double extinctionOf(double visibility_m);

SkyLight skyLight(const core::World& world, const Moment& moment);

}  // namespace sagara::render
