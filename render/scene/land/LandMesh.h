#pragma once

#include <vector>

#include "render/scene/land/Ground.h"

namespace sagara::render {

/// The land of an area as pieces small enough to be left out when they are behind the eye. Frame N, heights
/// above mean sea level. Coast cells are 10 m (5 m at quays, jetties and breakwaters) and cut along the
/// shoreline; inland cells are 80 m.
std::vector<Solid> landMesh(const core::Area& area, const Ground& ground);

/// Coast beyond the detailed land: a strip of shore and a strip of trees.
Solid distantCoast(const core::Area& area);

}  // namespace sagara::render
