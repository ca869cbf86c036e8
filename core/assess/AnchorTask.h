#pragma once

#include "core/assess/Task.h"

namespace sagara::core {

/// "anchor": brought up near a place ("at", within "within_m") on "shackles": [least, most] of cable: slower than
/// "speed_kn" over the ground for "still_s", anchor not moved for "hold_s", heading within "weather_deg" of the wind.
std::unique_ptr<const Task> makeAnchorTask(std::string id, std::string title, config::Reader& in,
                                           const MissionContext& context);

}  // namespace sagara::core
