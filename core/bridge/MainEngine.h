#pragma once

#include "core/motion/Propeller.h"

namespace sagara::core {

struct ShaftState;

/// The water a propeller works in.
struct PropellerWater {
    double inflow_mps = 0.0;
    double density_kgpm3 = 1025.0;
};

/// Runs an engine and its shaft for one tick towards an order of shaft speed: 2 pi I dn/dt = Qe - Qp - Qf.
/// The governor asks for the torque that follows the order at the unit's rate and gets no more than the
/// engine has: full from 0.8 of the full speed up, falling to 0.6 of it at a stand (charge air of a diesel).
/// Stopped, failed or reversing, the shaft runs as the water turns it. Reversing it is braked (0.2 of full
/// torque; a direct-drive engine by air, below 0.35 of full speed), stands for the unit's reversing time and
/// starts the other way. A direct-drive engine stops when the order is 0 and takes one start of air to turn
/// again, unless the water turns it that way fast enough; a start against more than 0.3 of full torque, while
/// the ship runs too fast, fails, uses the air and may be tried again after 8 s; no air, no start. It does
/// not run slower than idle. Shares are usual of such engines (Woodward, Low Speed Marine Diesel Engines
/// 1981), estimated.
void runEngine(const Propeller& propeller, ShaftState& shaft, double order_rps, const PropellerWater& water,
               double dt_s);

/// Most torque at a shaft speed.
double torqueLimit_Nm(const Engine& engine, double speed_rps);

}  // namespace sagara::core
