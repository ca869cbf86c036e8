#include "ui/report/TrackMoments.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Angle.h"

namespace sagara::report {
namespace {

constexpr double kMovedLengths = 0.6;
constexpr double kTurned_rad = 30.0 * core::kDegree_rad;

/// The speed she is faster than for a quarter of the run: what she does when she is under way.
double usualSpeed_mps(const std::vector<TrackPoint>& track) {
    std::vector<double> speeds_mps;
    for (const TrackPoint& p : track)
        speeds_mps.push_back(std::isfinite(p.speedOverGround_mps) ? p.speedOverGround_mps : 0.0);
    const auto upper = speeds_mps.begin() + static_cast<std::ptrdiff_t>(3 * speeds_mps.size() / 4);
    std::nth_element(speeds_mps.begin(), upper, speeds_mps.end());
    return *upper;
}

bool changed(const TrackPoint& a, const TrackPoint& b, double shipLength_m) {
    return core::distance(a.position, b.position) > kMovedLengths * shipLength_m ||
           std::abs(core::wrapPi(a.heading_rad - b.heading_rad)) > kTurned_rad;
}

}  // namespace

std::optional<std::size_t> pointAtTime(const std::vector<TrackPoint>& track, double time_s) {
    const auto found =
        std::lower_bound(track.begin(), track.end(), time_s,
                         [](const TrackPoint& p, double t_s) { return p.time_s < t_s - 1e-6; });
    if (found == track.end() || track.front().time_s > time_s + 1.0) return {};
    return static_cast<std::size_t>(found - track.begin());
}

double outlineInterval_s(const std::vector<TrackPoint>& track, double apart_m) {
    constexpr std::array<double, 8> kIntervals_s{10, 15, 30, 60, 120, 300, 600, 900};
    const double speed_mps = track.empty() ? 0.0 : usualSpeed_mps(track);
    for (const double interval_s : kIntervals_s) {
        if (interval_s * speed_mps >= apart_m) return interval_s;
    }
    return speed_mps > 0.1 ? 1800.0 : 60.0;
}

double tickInterval_s(const std::vector<TrackPoint>& track) {
    const double duration_s = track.empty() ? 0.0 : track.back().time_s;
    for (const double interval_s : {300.0, 900.0, 1800.0}) {
        if (duration_s <= 20.0 * interval_s) return interval_s;
    }
    return 3600.0;
}

std::vector<std::size_t> outlineMoments(const std::vector<TrackPoint>& track, double interval_s,
                                        double shipLength_m) {
    std::vector<std::size_t> moments;
    if (track.empty()) return moments;
    const double first_s = interval_s * std::ceil(track.front().time_s / interval_s);
    for (double t_s = first_s; t_s <= track.back().time_s; t_s += interval_s) {
        const std::optional<std::size_t> i = pointAtTime(track, t_s);
        if (!i || (!moments.empty() && !changed(track[moments.back()], track[*i], shipLength_m))) continue;
        moments.push_back(*i);
    }
    if (moments.empty()) moments.push_back(0);
    if (changed(track[moments.back()], track.back(), 0.5 * shipLength_m)) moments.push_back(track.size() - 1);
    return moments;
}

}  // namespace sagara::report
