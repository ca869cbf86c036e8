#pragma once

#include <algorithm>

#include "render/scene/shape/Solid.h"

namespace sagara::render {

/// The box a shape lies in.
struct Extent {
    Point low{1e9, 1e9, 1e9};
    Point high{-1e9, -1e9, -1e9};
};
inline Extent extentOf(const Solid& s) {
    Extent e;
    for (const SolidVertex& v : s.vertices) {
        e.low = {std::min(e.low.x, v.position.x), std::min(e.low.y, v.position.y),
                 std::min(e.low.up, v.position.up)};
        e.high = {std::max(e.high.x, v.position.x), std::max(e.high.y, v.position.y),
                  std::max(e.high.up, v.position.up)};
    }
    return e;
}

}  // namespace sagara::render
