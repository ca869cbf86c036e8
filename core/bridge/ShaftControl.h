#pragma once

#include <array>

#include "core/motion/Actuators.h"
#include "core/motion/Propeller.h"

namespace sagara::core {

/// One engine, its shaft, its blades and its azimuth drive, as lever and telegraph see them.
struct ShaftState {
    double order_rps = 0.0;  ///< of the lever, astern negative; with blades that turn it stands for both
    double speed_rps = 0.0;
    double standing_s = 0.0;     ///< time the shaft still has to stand before it may turn the other way
    std::int8_t lastTurned = 0;  ///< +1 ahead, -1 astern, 0 not yet
    bool failed = false;
    bool running = false;  ///< engine drives the shaft; only where the document has an engine
    double airUsed = 0.0;  ///< starts missing from the bottles
    double pitch = 1.0;    ///< over the design pitch
    double pitchOrder = 1.0;
    bool pitchByHand = false;  ///< pitchOrder holds until the lever is moved again
    double azimuth_rad = 0.0;  ///< where the drive pushes the ship, clockwise from ahead
    double azimuthOrder_rad = 0.0;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.order_rps, self.speed_rps, self.standing_s, self.lastTurned, self.failed, self.running,
           self.airUsed, self.pitch, self.pitchOrder, self.pitchByHand, self.azimuth_rad,
           self.azimuthOrder_rad);
    }
};
using ShaftStates = std::array<ShaftState, kMostShafts>;

/// Runs a shaft without an engine of its own in the document for one tick towards an order: rate limit, a
/// stand between ahead and astern (one that it has stood already counts). A failed engine lets it run down at
/// a third of the rate.
void runShaft(const PropulsionUnit& unit, ShaftState& shaft, double dt_s);

/// What lever and hand ask of shaft and blades.
struct ShaftDemand {
    double speed_rps = 0.0;
    double pitch = 1.0;
};
/// Fixed blades: the order. Blades that turn: the shaft at the order's revolutions, but no slower than the
/// document says and always ahead, and so much pitch that pitch times revolutions is the order.
ShaftDemand demandOf(const PropulsionUnit& unit, const ShaftState& shaft);

/// Every shaft of a ship for one tick: blades, azimuth drives (turned by their own order and by the wheel: a
/// rudder angle turns a drive abaft midship the other way), revolutions.
void runShafts(const std::vector<Propeller>& propellers, ShaftStates& shafts, const ShipMotion& m,
               double rudder_rad, double density_kgpm3, double dt_s);
/// Where the wheel alone would turn the azimuth drives of a ship without rudders.
void steerDrives(const Propulsion& propulsion, double rudder_rad, Actuators& actuators);
/// Shafts, blades and drives as they are.
void showShafts(const std::vector<Propeller>& propellers, const ShaftStates& shafts, Actuators& actuators);

/// Starts left in the bottles; none where the engine needs no air.
std::optional<double> startsLeft(const PropulsionUnit& unit, const ShaftState& shaft);

}  // namespace sagara::core
