#include "render/scene/sea/SeaGrid.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Units.h"

namespace sagara::render {
namespace {

/// Share of the rings within a distance; evenly in its logarithm between two of them.
struct Stop {
    double share;
    double distance_m;
};
constexpr std::array<Stop, 5> kStops{
    {{0.0, 1.0}, {0.16, 18.0}, {0.72, 420.0}, {0.90, 2'500.0}, {1.0, kSeaReach_m}}};

}  // namespace

double seaRing_m(double t) {
    std::size_t n = 1;
    while (n + 1 < kStops.size() && kStops[n].share < t) ++n;
    const Stop &a = kStops[n - 1], &b = kStops[n];
    const double f = (t - a.share) / (b.share - a.share);
    return a.distance_m * std::pow(b.distance_m / a.distance_m, f);
}

double seaGridFactor(double eyeHeight_m) { return std::clamp(std::sqrt(eyeHeight_m / 10.0), 0.6, 3.0); }

SeaGrid seaSector(int rings, int columns) {
    SeaGrid grid;
    for (int ring = 0; ring <= rings; ++ring) {
        const double t = static_cast<double>(ring) / rings, step = 1.0 / rings;
        const double r = seaRing_m(t);
        const double spacing =
            seaRing_m(std::min(1.0, t + 0.5 * step)) - seaRing_m(std::max(0.0, t - 0.5 * step));
        for (int column = 0; column <= columns; ++column) {
            const double azimuth = core::kTwoPi / kSeaSectors * column / columns;
            for (const double v : {std::sin(azimuth), 0.0, -std::cos(azimuth), r, spacing})
                grid.vertices.push_back(static_cast<float>(v));
        }
    }
    const auto width = static_cast<std::uint32_t>(columns + 1);
    for (std::uint32_t ring = 0; ring < static_cast<std::uint32_t>(rings); ++ring) {
        for (std::uint32_t column = 0; column + 1 < width; ++column) {
            const std::uint32_t i = ring * width + column;
            grid.indices.insert(grid.indices.end(), {i, i + 1, i + width + 1, i, i + width + 1, i + width});
        }
    }
    return grid;
}

}  // namespace sagara::render
