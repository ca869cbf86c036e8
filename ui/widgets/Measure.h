#pragma once

#include "core/base/LocalFrame.h"

namespace sagara::ui {

/// Distance and true bearing on the ellipsoid.
struct RangeBearing {
    double distance_m = 0.0;
    double bearing_rad = 0.0;  ///< from true north at `from`, 0 to 2 pi
};
/// By the azimuthal equidistant projection about `from`, in which both are exact (GeographicLib).
RangeBearing measure(const core::LocalFrame& frame, core::NorthEast from, core::NorthEast to);

/// The true direction of a direction of frame N at a place, 0 to 2 pi.
double trueDirection_rad(const core::LocalFrame& frame, core::NorthEast at, double direction_rad);

}  // namespace sagara::ui
