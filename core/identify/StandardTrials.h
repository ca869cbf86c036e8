#pragma once

#include "core/identify/CrashStop.h"
#include "core/identify/ImoStandards.h"
#include "core/identify/TurningCircle.h"
#include "core/identify/Zigzag.h"
#include "core/motion/ShipMotion.h"

namespace sagara::core {

/// The runs that the IMO standards ask for, all from full ahead in calm water.
struct StandardTrials {
    Trial turnStarboard;
    Trial turnPort;
    Trial zigzag10;
    Trial zigzag20;
    Trial stop;

    /// Cancelled when one of them was.
    bool cancelled() const;
};
/// `watch` is told the share of all and the title of the run that is on; false cancels.
using TrialsWatch = std::function<bool(double share, const std::string& run)>;
StandardTrials runStandardTrials(const Vessel& vessel, const TrialsWatch& watch = {},
                                 std::string_view model = {}, double depth_m = kDeepWater_m);

/// Steady speeds ahead and astern by telegraph step in deep water; 0 at Stop.
std::array<double, kTelegraphSteps> telegraphSpeeds_mps(const Vessel& vessel, std::string_view model = {});

}  // namespace sagara::core
