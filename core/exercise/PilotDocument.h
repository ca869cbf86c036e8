#pragma once

#include "core/assess/MissionContext.h"
#include "core/bridge/PilotScript.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {

/// "pilot" of a scenario: the steps of the scripted pilot of the first own ship.
PilotScript readPilotScript(config::Reader& scenario, const MissionContext& context, const Vessel& vessel);

}  // namespace sagara::core
