#include "core/bridge/EchoSounder.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {

EchoSounder sounderOf(const Vessel& vessel) {
    EchoSounder sounder;
    sounder.transducer = {0.25 * vessel.hull.lengthBp_m, 0.0};
    sounder.draught_m = vessel.hull.draught_m;
    return sounder;
}

double transducerDepth_m(BodyPoint at, double draught_m, const ShipMotion& m) {
    return draught_m + m.down_m - at.x_m * m.pitch_rad + at.y_m * m.roll_rad;
}

std::optional<double> soundedDepth_m(const Area& area, const EchoSounder& sounder, const ShipMotion& m,
                                     double tide_m) {
    constexpr int kAround = 8;
    const double transducer_m = transducerDepth_m(sounder.transducer, sounder.draught_m, m);
    const NorthEast at = HeadingFrame(m.position(), m.heading_rad).point(sounder.transducer);
    const double below_m = area.depth_m(at) + tide_m - transducer_m;
    double least_m = below_m;
    const double radius_m = std::max(0.0, below_m) * std::tan(sounder.halfBeam_rad);
    for (const double part : {0.5, 1.0})
        for (int i = 0; i < kAround; ++i) {
            const NorthEast off = part * radius_m * unitVector(kTwoPi * i / kAround);
            const double there_m = std::max(0.0, area.depth_m(at + off) + tide_m - transducer_m);
            least_m = std::min(least_m, std::sqrt(there_m * there_m + dot(off, off)));
        }
    if (least_m < sounder.least_m || least_m > sounder.most_m) return std::nullopt;
    return least_m;
}

}  // namespace sagara::core
