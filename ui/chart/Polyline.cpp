#include "ui/chart/Polyline.h"

#include <utility>

#include "core/base/Shapes.h"

namespace sagara::chart {
namespace {

using core::NorthEast;

struct Farthest {
    std::size_t index;
    double distance_m;
};

Farthest farthestFromChord(std::span<const NorthEast> line, std::size_t first, std::size_t last) {
    const core::Segment chord{line[first], line[last]};
    Farthest worst{first, -1.0};
    for (std::size_t i = first + 1; i < last; ++i) {
        const double d_m = core::distanceTo(chord, line[i]);
        if (d_m > worst.distance_m) worst = {i, d_m};
    }
    return worst;
}

}  // namespace

std::vector<NorthEast> simplified(std::span<const NorthEast> line, double tolerance_m) {
    if (line.size() < 3) return {line.begin(), line.end()};
    std::vector<bool> keep(line.size(), false);
    keep.front() = keep.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        const Farthest worst = farthestFromChord(line, first, last);
        if (worst.distance_m <= tolerance_m) continue;
        keep[worst.index] = true;
        open.emplace_back(first, worst.index);
        open.emplace_back(worst.index, last);
    }
    std::vector<NorthEast> kept;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (keep[i]) kept.push_back(line[i]);
    }
    return kept;
}

}  // namespace sagara::chart
