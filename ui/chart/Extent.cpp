#include "ui/chart/Extent.h"

#include <algorithm>
#include <cmath>

namespace sagara::chart {

void Extent::include(core::NorthEast p) {
    if (!std::isfinite(p.north_m) || !std::isfinite(p.east_m)) return;
    if (empty) southWest = northEast = p;
    empty = false;
    southWest = {std::min(southWest.north_m, p.north_m), std::min(southWest.east_m, p.east_m)};
    northEast = {std::max(northEast.north_m, p.north_m), std::max(northEast.east_m, p.east_m)};
}

}  // namespace sagara::chart
