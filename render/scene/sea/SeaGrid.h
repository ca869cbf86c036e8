#pragma once

#include <cstdint>
#include <vector>

namespace sagara::render {

/// The net the sea is drawn on: one sector of a disc about the eye, repeated all round. It stands still in
/// azimuth, so pictures side by side share its points. Rings lie closer where waves are seen from the side.
inline constexpr int kSeaSectors = 24;
inline constexpr double kSeaReach_m = 17'000.0;

struct SeaGrid {
    /// Five floats a point: unit direction (OGRE's axes: x east, y up, z south), distance, distance between
    /// rings.
    std::vector<float> vertices;
    std::vector<std::uint32_t> indices;
};
/// The sector from north to 15 deg east of it.
SeaGrid seaSector(int rings, int columns);

/// Distance of ring `t` (0 innermost to 1 outermost) before the factor for the height of the eye.
double seaRing_m(double t);
/// Factor on all distances: higher eyes look farther.
double seaGridFactor(double eyeHeight_m);

}  // namespace sagara::render
