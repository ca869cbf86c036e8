#pragma once

#include "core/bridge/OwnShip.h"
#include "core/bridge/PilotScript.h"

namespace sagara::core {

/// The scripted pilot: works wheel, shafts, lines and anchor of one own ship through the script, with nothing
/// that a person on the bridge would not know (position, heading, speeds, cable out). One tick.
void runPilot(const PilotScript& script, const RoutePath& path, const OwnShip& ship, OwnShipState& state,
              double dt_s);

}  // namespace sagara::core
