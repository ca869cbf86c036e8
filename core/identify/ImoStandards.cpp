#include "core/identify/ImoStandards.h"

#include <algorithm>

#include "core/identify/StandardTrials.h"

namespace sagara::core {

ImoLimits imoLimits(double lengthBp_m, double speed_mps) {
    const double pace_s = std::clamp(lengthBp_m / speed_mps, 10.0, 30.0);
    ImoLimits limits;
    limits.zigzag10First_deg = 5.0 + 0.5 * pace_s;
    limits.zigzag10Second_deg = 17.5 + 0.75 * pace_s;
    return limits;
}

std::vector<ImoCheck> imoChecks(const StandardTrials& t) {
    const ImoLimits limits = imoLimits(t.turnStarboard.length_m, t.turnStarboard.approach_mps);
    return {
        {"Advance, to starboard", "L", t.turnStarboard.measure("advance_over_L"), limits.advance_L},
        {"Advance, to port", "L", t.turnPort.measure("advance_over_L"), limits.advance_L},
        {"Tactical diameter, to starboard", "L", t.turnStarboard.measure("tactical_diameter_over_L"),
         limits.tacticalDiameter_L},
        {"Tactical diameter, to port", "L", t.turnPort.measure("tactical_diameter_over_L"),
         limits.tacticalDiameter_L},
        {"Initial turning, 10 deg of rudder", "L", t.zigzag10.measure("initial_turning_over_L"),
         limits.initialTurning_L},
        {"10/10 zigzag, first overshoot", "deg", t.zigzag10.measure("overshoot_1_deg"),
         limits.zigzag10First_deg},
        {"10/10 zigzag, second overshoot", "deg", t.zigzag10.measure("overshoot_2_deg"),
         limits.zigzag10Second_deg},
        {"20/20 zigzag, first overshoot", "deg", t.zigzag20.measure("overshoot_1_deg"),
         limits.zigzag20First_deg},
        {"Track reach, full astern", "L", t.stop.measure("track_reach_over_L"), limits.trackReach_L},
    };
}

}  // namespace sagara::core
