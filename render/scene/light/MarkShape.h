#pragma once

#include "core/world/Area.h"
#include "render/scene/shape/Solid.h"

namespace sagara::render {

/// A buoy or beacon by its kind in the IALA system; region "A" or "B". Its lamp is at the height of its
/// light.
Solid shapeOf(const core::Mark& mark, bool regionB);
double lampHeight_m(const core::Mark& mark);

}  // namespace sagara::render
