#pragma once

#include "core/base/Config.h"
#include "core/base/Planar.h"

namespace sagara::core {

/// "x_m" and "y_m" of the object being read, frame B.
inline BodyPoint readBodyPoint(config::Reader& in) {
    return {in.number("x_m", {-300.0, 300.0, "m"}), in.number("y_m", {-50.0, 50.0, "m"})};
}

}  // namespace sagara::core
