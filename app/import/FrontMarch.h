#pragma once

#include <limits>
#include <vector>

#include "app/import/Raster.h"

namespace sagara::importer {

inline constexpr double kUnreached_m = std::numeric_limits<double>::infinity();

/// Way of a wave front to every node, round whatever blocks it: |grad T| = 1 by fast marching (Sethian 1996,
/// PNAS 93(4), 1591-1595), first order. `seeds_m`: way already made at the nodes where the front enters, else
/// kUnreached_m. Blocked nodes stay unreached. Straight fronts come out exactly, circular ones behind a
/// corner a few per cent late.
std::vector<double> marchFront(const Raster& raster, const std::vector<char>& blocked,
                               std::vector<double> seeds_m);

}  // namespace sagara::importer
