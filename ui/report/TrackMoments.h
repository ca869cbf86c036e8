#pragma once

#include <optional>
#include <vector>

#include "ui/report/ReportData.h"

namespace sagara::report {

/// The track point at a time, the first not before it; nothing outside the track.
std::optional<std::size_t> pointAtTime(const std::vector<TrackPoint>& track, double time_s);

/// Seconds between two outlines of the ship, so that at her usual speed they lie `apart_m` apart or more.
double outlineInterval_s(const std::vector<TrackPoint>& track, double apart_m);

/// Seconds between two time ticks: five minutes, more in runs of hours.
double tickInterval_s(const std::vector<TrackPoint>& track);

/// Points at every interval, less those where she has hardly moved or turned since the last: a ship alongside
/// or at anchor is drawn once, not a hundred times.
std::vector<std::size_t> outlineMoments(const std::vector<TrackPoint>& track, double interval_s,
                                        double shipLength_m);

}  // namespace sagara::report
