#pragma once

#include "core/base/Units.h"
#include "core/identify/Trial.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {

class TrialShip;

/// Rudder over and held. Measures, with the turning side positive and midship as reference (MSC.137(76),
/// ITTC free-running procedures): initial_U_ms, advance_over_L, transfer_over_L, t90_s, U90_ms at 90 deg,
/// tactical_diameter_over_L, t180_s, U180_ms at 180 deg, max_advance_over_L, max_transfer_over_L, and over
/// 360 to 720 deg steady_diameter_over_L, steady_r_dps, steady_U_ms, steady_speed_ratio, steady_drift_deg
/// (bow inside is positive), steady_beta_deg (atan2(-v, u)). Roll, starboard down positive: max_roll_deg,
/// min_roll_deg, final_roll_deg, and max_heel_to_port_deg, max_heel_to_starboard_deg,
/// steady_heel_to_port_deg. L is between perpendiculars.
struct TurningCircle {
    double rudder_rad = 35.0 * kDegree_rad;  ///< positive to starboard
    double turn_rad = 540.0 * kDegree_rad;   ///< heading change at which it ends
};
Trial runTurningCircle(TrialShip& ship, const TurningCircle& turn, const TrialOptions& options = {});
Trial runTurningCircle(const Vessel& vessel, const TurningCircle& turn, const TrialOptions& options = {});

}  // namespace sagara::core
