#include "core/world/MooringLine.h"

#include <algorithm>

namespace sagara::core {
namespace {

constexpr double kShortest_m = 2.0;  // a line cannot be hove shorter than this
constexpr double kHaulFactor = 3.0;  // a free line comes in this much faster than the winch heaves
constexpr double kDampingTime_s =
    0.15;  // damping over stiffness: hysteresis of a synthetic line, some 10 % of critical

}  // namespace

const char* lineStatusName(LineStatus status) {
    switch (status) {
        case LineStatus::In:
            return "in";
        case LineStatus::Fast:
            return "fast";
        case LineStatus::Slacking:
            return "slacking";
        case LineStatus::Heaving:
            return "heaving";
        case LineStatus::CastOff:
            return "castOff";
        case LineStatus::Parted:
            return "parted";
    }
    return "";
}

double lineTension_N(const MooringGear& gear, const LineState& line, double distance_m,
                     double stretchRate_mps) {
    if (!line.onBollard() || distance_m <= line.length_m) return 0.0;
    const double perMetre_N = gear.stiffness_N / line.length_m;
    return std::max(0.0, perMetre_N * (distance_m - line.length_m + kDampingTime_s * stretchRate_mps));
}

Load lineLoad(const MooringGear& gear, const LineLayout& layout, const LineState& line, const ShipMotion& m,
              NorthEast current) {
    if (!line.onBollard()) return {};
    const HeadingFrame frame(m.position(), m.heading_rad);
    const NorthEast lead = layout.bollard - frame.point(layout.fairlead);
    const double distance_m = length(lead);
    if (distance_m <= line.length_m) return {};
    const NorthEast direction = (1.0 / distance_m) * lead;
    const NorthEast velocity = frame.vector(velocityAt(m, layout.fairlead)) + current;
    const double tension_N = lineTension_N(gear, line, distance_m, -dot(velocity, direction));
    return forceAt(layout.fairlead, 0.0, frame.vectorInBody(tension_N * direction));
}

bool workLine(const MooringGear& gear, const LineLayout& layout, LineState& line, const ShipMotion& m,
              double dt_s) {
    const double step_m = gear.winchSpeed_mps * dt_s;
    if (line.status == LineStatus::CastOff) {
        line.length_m = std::max(0.0, line.length_m - kHaulFactor * step_m);
        line.tension_N = 0.0;
        if (line.length_m == 0.0) line.status = LineStatus::In;
    }
    if (!line.onBollard()) return false;
    const HeadingFrame frame(m.position(), m.heading_rad);
    line.tension_N = lineTension_N(gear, line, distance(frame.point(layout.fairlead), layout.bollard), 0.0);
    if (line.status == LineStatus::Slacking) line.length_m += step_m;
    if (line.status == LineStatus::Heaving && line.tension_N < gear.winchPull_N) {
        line.length_m = std::max(kShortest_m, line.length_m - step_m);
    }
    if (line.tension_N <= gear.breakingLoad_N) return false;
    line = {LineStatus::Parted, 0.0, 0.0};
    return true;
}

LineState madeFast(const LineLayout& layout, const ShipMotion& m) {
    constexpr double kPretension = 0.998;  // of the distance: 0.2 % stretch
    const HeadingFrame frame(m.position(), m.heading_rad);
    const double distance_m = distance(frame.point(layout.fairlead), layout.bollard);
    return {LineStatus::Fast, std::max(kShortest_m, kPretension * distance_m), 0.0};
}

}  // namespace sagara::core
