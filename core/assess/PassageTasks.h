#pragma once

#include "core/assess/Task.h"

namespace sagara::core {

/// "gate": midship crosses the line between two places ("between": two ids or positions), from the side of
/// the first waypoint of the route.
std::unique_ptr<const Task> makeGateTask(std::string id, std::string title, config::Reader& in,
                                         const MissionContext& context);

/// "transit": comes within "within_M" of a place ("to") that the route leads to.
std::unique_ptr<const Task> makeTransitTask(std::string id, std::string title, config::Reader& in,
                                            const MissionContext& context);

}  // namespace sagara::core
