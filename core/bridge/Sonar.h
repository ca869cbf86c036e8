#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/Units.h"
#include "core/motion/ShipMotion.h"
#include "core/vessel/Vessel.h"
#include "core/world/Area.h"
#include "core/world/Target.h"

/// A forward-looking sonar that sees the bottom and what floats in the water ahead of the ship. A pure
/// function from depths and hulls to one ping.
namespace sagara::core {

struct Sonar {
    BodyPoint transducer;
    double draught_m = 0.0;
};
/// Under the forefoot.
Sonar sonarOf(const Vessel& vessel);

inline constexpr std::array kSonarRanges_m{100.0, 200.0, 400.0, 600.0};

/// A hull in the water. Depth: from the surface down.
struct SonarObject {
    NorthEast position;
    double heading_rad = 0.0;
    double length_m = 0.0;
    double beam_m = 0.0;
    double draught_m = 0.0;
};

struct SonarPicture {
    static constexpr std::size_t kBeams = 91;  ///< a degree each; the middle one is right ahead
    static constexpr std::size_t kCells = 256;
    static constexpr double kHalfSector_rad = 45.0 * kDegree_rad;
    static constexpr float kUnseen = std::numeric_limits<float>::quiet_NaN();

    double range_m = 0.0;
    std::vector<std::uint8_t> levels = std::vector<std::uint8_t>(kBeams * kCells);  ///< 0 nothing to 255
    /// Depth of the bottom below still water where it gives an echo, else kUnseen.
    std::vector<float> bottom_m = std::vector<float>(kBeams * kCells, kUnseen);
    std::vector<std::uint8_t> contacts = std::vector<std::uint8_t>(kBeams * kCells);  ///< hulls only
    /// What an operator would mark: the nearest echo of every hull.
    struct Contact {
        double range_m = 0.0;
        double bearing_rad = 0.0;  ///< from ahead, positive to starboard
        double draught_m = 0.0;
    };
    std::vector<Contact> found;

    std::size_t index(std::size_t beam, std::size_t cell) const { return beam * kCells + cell; }
    static double beam_rad(std::size_t beam) {
        return (static_cast<double>(beam) - 0.5 * static_cast<double>(kBeams - 1)) * kDegree_rad;
    }
    double cell_m() const { return range_m / static_cast<double>(kCells); }
};

/// By how much an echo of the bottom stands out of the noise, dB: Lambert's rule, spreading, absorption at
/// 60 kHz. Calm water shows a flat bottom out to some eleven times its depth; over 8 kn the flow takes 1.5 dB
/// a knot.
double bottomEcho_dB(double range_m, double grazing_rad, double speed_mps);
/// The same of a hull by the size of its side in the water.
double hullEcho_dB(double range_m, double length_m, double draught_m, double speed_mps);

SonarPicture ping(const Area& area, std::span<const SonarObject> objects, const Sonar& sonar,
                  const ShipMotion& motion, double tide_m, double range_m, std::uint32_t seed);

/// Distance to the nearest bottom ahead that is shallower than a depth, within so many degrees of the bow.
std::optional<double> shoalAhead_m(const SonarPicture& picture, double depth_m, double within_rad);

}  // namespace sagara::core
