#pragma once

#include <optional>

#include "core/bridge/EchoSounder.h"
#include "core/exercise/Snapshot.h"

namespace sagara::ui::console {

/// What the sensors of one own ship say at a moment: true directions, SI.
struct ShipReadings {
    double heading_rad = 0.0;      ///< true
    double convergence_rad = 0.0;  ///< add to a direction of frame N to make it true
    double turn_radps = 0.0;
    double overGround_mps = 0.0;
    std::optional<double> course_rad;               ///< true; none when she hardly moves
    double ahead_mps = 0.0, toStarboard_mps = 0.0;  ///< through the water
    double windFrom_rad = 0.0, wind_mps = 0.0;      ///< true wind
    double relativeFrom_rad = 0.0, relative_mps = 0.0;
    std::optional<double> underKeel_m;  ///< by echo sounder
};

ShipReadings readingsOf(const core::World& world, const core::Snapshot& now, std::size_t ship,
                        const core::EchoSounder& sounder);

}  // namespace sagara::ui::console
