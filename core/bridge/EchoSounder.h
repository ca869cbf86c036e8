#pragma once

#include <optional>

#include "core/base/Units.h"
#include "core/motion/ShipMotion.h"
#include "core/vessel/Vessel.h"
#include "core/world/Area.h"

namespace sagara::core {

/// The transducer of an echo sounder, flush with the keel.
struct EchoSounder {
    BodyPoint transducer;
    double draught_m = 0.0;
    double halfBeam_rad = 10.0 * kDegree_rad;
    double least_m = 0.3;  ///< nearer the pulse covers its own echo
    double most_m = 200.0;
};
/// A quarter of the length forward of midship.
EchoSounder sounderOf(const Vessel& vessel);

/// How deep the transducer is below still water, as the ship heaves, rolls and pitches.
double transducerDepth_m(BodyPoint at, double draught_m, const ShipMotion& motion);

/// Water under the transducer: the shortest way to the bottom within the beam, over the depth of the area and
/// the tide. Nothing when it is too near or too far for an echo.
std::optional<double> soundedDepth_m(const Area& area, const EchoSounder& sounder, const ShipMotion& motion,
                                     double tide_m);

}  // namespace sagara::core
