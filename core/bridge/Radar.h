#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/Units.h"
#include "core/vessel/Vessel.h"
#include "core/world/Area.h"
#include "core/world/Target.h"

/// A navigation radar of X band, 9.4 GHz: what its antenna gets back from coast, marks and ships. Sea clutter
/// and rain are not in it. Pure functions; who turns the antenna is up to the caller.
namespace sagara::core {

struct RadarSet {
    BodyPoint antenna;  ///< on the ship
    double antennaHeight_m = 15.0;
    double beamWidth_rad = 1.2 * kDegree_rad;  ///< between half powers
    double blind_m = 30.0;                     ///< nearer nothing is seen
};
/// On the mast above the wheelhouse.
RadarSet radarOf(const Vessel& vessel);

inline constexpr std::array kRadarRanges_M{0.25, 0.5, 0.75, 1.5, 3.0, 6.0, 12.0};
inline constexpr double kRadarTurn_s = 2.5;                       ///< 24 turns a minute
inline constexpr double kRadarEarth_m = 4.0 / 3.0 * 6'371'000.0;  ///< radius that bends as radar waves do
inline constexpr double kRadarBeach_m = 3.0;                      ///< least height of land that reflects

/// How long an echo of a point is in the picture, half the length of the pulse: 0.07 microseconds up to
/// 0.75 M, 0.25 up to 3 M, 0.7 beyond.
double radarEcho_m(double range_m);
/// As far as radar waves see the water from a height: four thirds of the earth's radius.
double radarHorizon_m(double height_m);
/// Smallest cross-section that just shows: as the fourth power of the range, 10 m2 at 4.9 M (IMO
/// MSC.192(79), table 2: a buoy with a reflector).
double leastCrossSection_m2(double range_m);

/// Something that is not land. Length 0: a point.
struct RadarObject {
    NorthEast position;
    double heading_rad = 0.0;
    double length_m = 0.0;
    double beam_m = 0.0;
    double height_m = 0.0;  ///< of what reflects, above the water
    double crossSection_m2 = 0.0;
};
/// By her length: 2.5 m2 for a wooden boat of 7 m, 2000 m2 for a ship of 100 m.
RadarObject radarObjectOf(const TargetLayout& layout, NorthEast position, double heading_rad);
RadarObject radarObjectOf(const Mark& mark);

/// The land of an area as a radar sees it. The area outlives it.
class RadarCoast {
public:
    explicit RadarCoast(const Area& area);
    struct Edge {
        NorthEast a, b;
    };
    const std::vector<Edge>& rings() const { return m_rings; }  ///< land on the right hand from a to b
    const std::vector<Edge>& walls() const { return m_walls; }  ///< breakwaters and jetties
    double height_m(NorthEast p) const;                         ///< of land, at least that of a beach

private:
    const Area& m_area;
    std::vector<Edge> m_rings;
    std::vector<Edge> m_walls;
};

/// Echoes by azimuth from north of frame N and range; 0 nothing, 255 saturated.
struct RadarPicture {
    static constexpr std::size_t kAzimuths = 1440;
    static constexpr std::size_t kCells = 1024;
    static constexpr double kStep_rad = kTwoPi / static_cast<double>(kAzimuths);

    double range_m = 0.0;
    std::vector<std::uint8_t> levels = std::vector<std::uint8_t>(kAzimuths * kCells);

    double cell_m() const { return range_m / static_cast<double>(kCells); }
    std::uint8_t at(std::size_t azimuth, std::size_t cell) const { return levels[azimuth * kCells + cell]; }
    void clear(double newRange_m);
};

/// Renews `count` azimuths from `first` on, as the antenna passes them; round the north as it comes. `seed`
/// moves the noise from turn to turn.
void sweepRadar(const RadarCoast& coast, std::span<const RadarObject> objects, NorthEast antenna,
                const RadarSet& set, std::size_t first, std::size_t count, std::uint32_t seed,
                RadarPicture& picture);

}  // namespace sagara::core
