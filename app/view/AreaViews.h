#pragma once

#include <string>
#include <vector>

#include "core/world/Area.h"
#include "render/scene/Camera.h"

namespace sagara::view {

struct AreaView {
    std::string name;
    render::Camera camera;
};

/// How an area looks to those who come to it: its entrances and forts from seaward, land from its anchorages,
/// its lights through binoculars, and the first entrance from the air. Named after the places and marks.
std::vector<AreaView> viewsOf(const core::Area& area, const render::Lens& lens);

}  // namespace sagara::view
