#pragma once

#include <vector>

#include "render/scene/sky/Almanac.h"

namespace sagara::render {

/// A star as the picture needs it. Positions J2000.0 to a tenth of a degree: precession until 2050 is less
/// than a degree and the same for all.
struct Star {
    Equatorial position;
    double magnitude = 0.0;
};

/// The brightest stars, those of the nautical almanac among them, and faint ones scattered by a fixed seed to
/// the counts by magnitude of the real sky.
std::vector<Star> starsOfTheSky();

}  // namespace sagara::render
