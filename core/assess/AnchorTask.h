#pragma once

#include "core/assess/Task.h"

namespace sagara::core {

/// "anchor": brought up near a place ("at", within "within_m") on "shackles": [least, most] of cable: made
/// good less than "speed_kn" over "still_s", anchor held for "hold_s", heading within "weather_deg" of the
/// wind. A jerk that shifts the anchor costs seconds of the time it has held; a dragging one never holds. The
/// speed is that made good because a swell surges a ship at anchor to and fro by half a knot; it is ticked
/// off at a whole second in which she lies as still as that between two waves.
std::unique_ptr<const Task> makeAnchorTask(std::string id, std::string title, config::Reader& in,
                                           const MissionContext& context);

}  // namespace sagara::core
