#pragma once

#include <vector>

#include "render/scene/Preset.h"
#include "render/scene/land/Ground.h"

namespace sagara::render {

/// What stands on the land: lighthouse, landmarks, sheds on the quays, houses, palms. In pieces as the
/// land's. Frame N, heights above mean sea level. The places of houses and palms are ours, from a fixed seed.
std::vector<Solid> buildings(const core::Area& area, const Ground& ground, const PresetFigures& figures);

}  // namespace sagara::render
