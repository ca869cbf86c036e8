#include "ui/report/SpeedLimits.h"

#include <algorithm>

namespace sagara::report {
namespace {

/// A ship is looked for this far behind and ahead of where she was on the route: enough for a track every 10
/// s.
constexpr double kBehind_m = 50.0;
constexpr double kAhead_m = 300.0;

std::vector<double> legLimits_mps(const RunReport& report) {
    std::vector<double> limits_mps;
    double along_m = 0.0;
    for (const TrackPoint& point : report.track) {
        const core::RoutePath::Place here = report.path.nearest(point.position, along_m, kBehind_m, kAhead_m);
        along_m = here.along_m;
        limits_mps.push_back(
            here.leg < report.route.waypoints.size() ? report.route.waypoints[here.leg].speedMax_mps : 0.0);
    }
    return limits_mps;
}

std::vector<double> recordedLimits_mps(const RunReport& report) {
    std::vector<double> limits_mps;
    for (const TrackPoint& point : report.track) limits_mps.push_back(point.speedLimit_mps);
    return limits_mps;
}

bool anyKnown(const std::vector<double>& limits_mps) {
    return std::any_of(limits_mps.begin(), limits_mps.end(),
                       [](double limit_mps) { return limit_mps > 0.0; });
}

}  // namespace

std::vector<double> speedLimits_mps(const RunReport& report) {
    if (std::vector<double> recorded = recordedLimits_mps(report); anyKnown(recorded)) return recorded;
    if (report.path.length_m() <= 0.0) return {};
    std::vector<double> legs = legLimits_mps(report);
    return anyKnown(legs) ? legs : std::vector<double>{};
}

}  // namespace sagara::report
