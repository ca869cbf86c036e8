#pragma once

#include "core/identify/Trial.h"

namespace sagara::core {

class TrialShip;

/// The ship is held heeled, trimmed or pressed down on a straight course and let go. Measures: period_s (mean
/// of the swings), damping_ratio (of critical: by the logarithmic decrement, mean over the swings above a
/// twentieth of the first), swings (how many of them), peak_1, peak_2 ... (each to the other side; deg or m).
struct Decay {
    enum class Dof { Roll, Heave, Pitch };
    Dof dof = Dof::Roll;
    double start = 0.1;  ///< rad (starboard side down, bow up) or m (down)
};
Trial runDecay(TrialShip& ship, const Decay& decay, const TrialOptions& options = {});

/// The motion that swings, of a sample: rad or m.
double decayingMotion(const TrialSample& sample, Decay::Dof dof);

}  // namespace sagara::core
