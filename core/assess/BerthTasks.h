#pragma once

#include "core/assess/Task.h"

namespace sagara::core {

/// "spring-off": singled up to the lines in "keep", then, with these still holding, turned "swing_deg" from
/// the heading she lay at.
std::unique_ptr<const Task> makeSpringOffTask(std::string id, std::string title, config::Reader& in,
                                              const MissionContext& context);

/// "clear-of-berth": all lines aboard and the hull at least "distance_m" from any quay or shore.
std::unique_ptr<const Task> makeClearOfBerthTask(std::string id, std::string title, config::Reader& in,
                                                 const MissionContext& context);

}  // namespace sagara::core
