#pragma once

#include "core/identify/CrashStop.h"
#include "core/identify/ImoStandards.h"
#include "core/identify/TurningCircle.h"
#include "core/identify/Zigzag.h"

namespace sagara::core {

/// The runs that the IMO standards ask for, all from full ahead in deep calm water.
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
StandardTrials runStandardTrials(const Vessel& vessel, const TrialsWatch& watch = {});

/// Steady speeds ahead and astern by telegraph step; 0 at Stop.
std::array<double, kTelegraphSteps> telegraphSpeeds_mps(const Vessel& vessel);

}  // namespace sagara::core
