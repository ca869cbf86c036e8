#include "core/bridge/Radar.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Angle.h"
#include "core/bridge/SensorNoise.h"

namespace sagara::core {
namespace {

constexpr double kWallSection = 0.3;  ///< cross-section of a metre of breakwater or cliff, m2
constexpr double kLandGamma = 0.1;    ///< cross-section of land per area and sine of the grazing angle
constexpr double kLeastGrazing = 0.01;
constexpr std::size_t kBatch = 48;
constexpr std::size_t kCells = RadarPicture::kCells;

std::uint8_t levelOf(double crossSection_m2, double range_m, double noise_dB) {
    const double over_dB =
        10.0 * std::log10(std::max(crossSection_m2, 1e-9) / leastCrossSection_m2(range_m)) + noise_dB;
    return over_dB < 0.0 ? 0 : static_cast<std::uint8_t>(std::min(255.0, 90.0 + 6.0 * over_dB));
}

/// How high a point stands over the level of the antenna, as a tangent, on an earth that curves away.
double tangent(double height_m, double antenna_m, double range_m) {
    return (height_m - antenna_m) / range_m - range_m / (2.0 * kRadarEarth_m);
}

/// One thin beam: what comes back, and over what one would have to stand to be seen.
struct Ray {
    std::array<std::uint8_t, kCells> levels;
    std::array<float, kCells> skyline;
};

struct Crossing {
    double range_m;
    int into;  ///< +1 into the land, -1 out of it
};

class Sweep {
public:
    Sweep(const RadarCoast& coast, NorthEast antenna, const RadarSet& set, double range_m, std::uint32_t seed)
        : m_coast(coast),
          m_antenna(antenna),
          m_set(set),
          m_range_m(range_m),
          m_cell_m(range_m / kCells),
          m_echoCells(std::max<std::size_t>(
              1, static_cast<std::size_t>(std::lround(radarEcho_m(range_m) / m_cell_m)))),
          m_seed(seed) {}

    /// Rays `first` and the next ones, counted round; their echoes already as long as the pulse.
    void run(std::int64_t first, std::vector<Ray>& rays, std::span<const RadarObject> objects) {
        m_first = first;
        m_rays = &rays;
        findCrossings();
        for (std::size_t i = 0; i < rays.size(); ++i) castLand(i);
        for (const RadarObject& object : objects) castObject(object);
    }

private:
    double azimuth_rad(std::size_t ray) const {
        return static_cast<double>(m_first + static_cast<std::int64_t>(ray)) * RadarPicture::kStep_rad;
    }
    double noise_dB(std::size_t ray, std::size_t cell) const {
        const auto azimuth = static_cast<std::uint32_t>(m_first + static_cast<std::int64_t>(ray));
        return 4.0 * (sensorNoise(m_seed, azimuth / 2, static_cast<std::uint32_t>(cell / 4)) - 0.5);
    }

    template <typename Found>
    void crossings(const std::vector<RadarCoast::Edge>& edges, Found&& found) const {
        const std::size_t n = m_rays->size();
        const double middle_rad = azimuth_rad(n / 2);
        const NorthEast middle = unitVector(middle_rad);
        const double half_rad = RadarPicture::kStep_rad * (static_cast<double>(n) / 2.0 + 1.0);
        const double cosHalf = std::cos(half_rad);
        for (const RadarCoast::Edge& edge : edges) {
            const NorthEast a = edge.a - m_antenna, b = edge.b - m_antenna;
            // Wholly outside the sector and on one side of it: most of them.
            const double aAhead = dot(a, middle), bAhead = dot(b, middle);
            if (aAhead < 0.0 && bAhead < 0.0) continue;
            const double aSide = cross(middle, a), bSide = cross(middle, b);
            const bool aOut = aAhead < cosHalf * length(a), bOut = bAhead < cosHalf * length(b);
            if (aOut && bOut && aSide * bSide > 0.0) continue;
            for (std::size_t i = 0; i < n; ++i) {
                const NorthEast d = m_directions[i];
                const double aAcross = cross(d, a), bAcross = cross(d, b);
                if ((aAcross < 0.0) == (bAcross < 0.0)) continue;
                const double t = aAcross / (aAcross - bAcross);
                const double range_m = dot(d, a + t * (b - a));
                if (range_m > 0.0 && range_m < m_range_m) found(i, range_m, aAcross < 0.0 ? -1 : 1);
            }
        }
    }

    void findCrossings() {
        const std::size_t n = m_rays->size();
        m_directions.resize(n);
        m_crossings.assign(n, {});
        m_walls.assign(n, {});
        for (std::size_t i = 0; i < n; ++i) m_directions[i] = unitVector(azimuth_rad(i));
        // Land lies to the right of an edge: who sees it go from right to left comes upon land.
        crossings(m_coast.rings(), [&](std::size_t ray, double range_m, int into) {
            m_crossings[ray].push_back({range_m, into});
        });
        crossings(m_coast.walls(),
                  [&](std::size_t ray, double range_m, int) { m_walls[ray].push_back(range_m); });
        for (auto& list : m_crossings)
            std::sort(list.begin(), list.end(),
                      [](const Crossing& a, const Crossing& b) { return a.range_m < b.range_m; });
    }

    void put(std::size_t ray, std::size_t cell, std::uint8_t level) {
        auto& levels = (*m_rays)[ray].levels;
        const std::size_t end = std::min(kCells, cell + m_echoCells);
        for (std::size_t i = cell; i < end; ++i) levels[i] = std::max(levels[i], level);
    }

    void castLand(std::size_t ray) {
        Ray& out = (*m_rays)[ray];
        out.levels.fill(0);
        auto& walls = m_walls[ray];
        const auto& coast = m_crossings[ray];
        // Beyond the horizon only what stands over it is seen.
        const double horizon_m = radarHorizon_m(m_set.antennaHeight_m);
        const double seaTangent = tangent(0.0, m_set.antennaHeight_m, horizon_m);
        const double width_m = 2.0 * std::tan(0.5 * m_set.beamWidth_rad);
        const double echo_m = static_cast<double>(m_echoCells) * m_cell_m;
        double skyline = -1e9, before_m = 0.0;
        int inside = 0;  // the antenna is afloat
        std::size_t next = 0;
        for (std::size_t cell = 0; cell < kCells; ++cell) {
            const double begin_m = static_cast<double>(cell) * m_cell_m, end_m = begin_m + m_cell_m;
            const double range_m = begin_m + 0.5 * m_cell_m;
            if (range_m > horizon_m) skyline = std::max(skyline, seaTangent);
            out.skyline[cell] = static_cast<float>(skyline);
            bool edge = false, land = inside > 0;
            while (next < coast.size() && coast[next].range_m < end_m) {
                inside = std::max(0, inside + coast[next].into);
                if (coast[next].into > 0) edge = land = true;
                ++next;
            }
            const bool wall = std::any_of(walls.begin(), walls.end(),
                                          [&](double at_m) { return at_m >= begin_m && at_m < end_m; });
            if (!land && !wall) {
                before_m = 0.0;
                continue;
            }
            const NorthEast at = m_antenna + range_m * m_directions[ray];
            const double height_m = land ? m_coast.height_m(at) : kRadarBeach_m;
            const double over = tangent(height_m, m_set.antennaHeight_m, range_m);
            if (range_m > m_set.blind_m && over >= skyline) {
                const double slope = edge || wall ? 0.0 : (height_m - before_m) / m_cell_m;
                const double grazing = std::max(kLeastGrazing, slope - over);
                double section_m2 = kLandGamma * std::min(1.0, grazing) * width_m * range_m * echo_m;
                if (edge || wall) section_m2 += kWallSection * width_m * range_m * kRadarBeach_m;
                put(ray, cell, levelOf(section_m2, range_m, noise_dB(ray, cell)));
            }
            skyline = std::max(skyline, over);
            before_m = height_m;
        }
    }
    void castObject(const RadarObject& object) {
        const double far_m = distance(m_antenna, object.position);
        if (far_m - object.length_m > m_range_m || far_m < 1.0) return;
        if (object.length_m <= 0.0) return castPoint(object.position, object);
        const HeadingFrame frame(object.position, object.heading_rad);
        const double x = 0.5 * object.length_m, y = 0.5 * object.beam_m;
        const std::array<BodyPoint, 4> corners{{{x, y}, {x, -y}, {-x, -y}, {-x, y}}};
        // The sides that look at the antenna give the echo.
        for (std::size_t i = 0; i < 4; ++i) {
            const NorthEast a = frame.point(corners[i]), b = frame.point(corners[(i + 1) % 4]);
            const NorthEast outward = -1.0 * turnedRight(b - a);  // corners go anticlockwise
            const NorthEast middle = 0.5 * (a + b);
            if (dot(outward, m_antenna - middle) <= 0.0) continue;
            const double step_m = std::max(0.5 * m_cell_m, 0.5 * far_m * RadarPicture::kStep_rad);
            const int steps = std::clamp(static_cast<int>(std::ceil(distance(a, b) / step_m)), 1, 400);
            for (int k = 0; k <= steps; ++k)
                castPoint(a + (static_cast<double>(k) / steps) * (b - a), object);
        }
    }

    void castPoint(NorthEast at, const RadarObject& object) {
        const double range_m = distance(m_antenna, at);
        if (range_m <= m_set.blind_m || range_m >= m_range_m) return;
        const auto azimuth = static_cast<std::int64_t>(
            std::lround(wrapTwoPi(bearing_rad(m_antenna, at)) / RadarPicture::kStep_rad));
        constexpr auto kAll = static_cast<std::int64_t>(RadarPicture::kAzimuths);
        const std::int64_t offset = ((azimuth - m_first) % kAll + kAll) % kAll;
        if (offset >= static_cast<std::int64_t>(m_rays->size())) return;
        const auto ray = static_cast<std::size_t>(offset);
        const auto cell = std::min(kCells - 1, static_cast<std::size_t>(range_m / m_cell_m));
        const double over = tangent(object.height_m, m_set.antennaHeight_m, range_m);
        if (over < static_cast<double>((*m_rays)[ray].skyline[cell])) return;
        put(ray, cell, levelOf(object.crossSection_m2, range_m, noise_dB(ray, cell)));
    }

    const RadarCoast& m_coast;
    NorthEast m_antenna;
    const RadarSet& m_set;
    double m_range_m;
    double m_cell_m;
    std::size_t m_echoCells;
    std::uint32_t m_seed;
    std::int64_t m_first = 0;
    std::vector<Ray>* m_rays = nullptr;
    std::vector<NorthEast> m_directions;
    std::vector<std::vector<Crossing>> m_crossings;
    std::vector<std::vector<double>> m_walls;
};

}  // namespace

void sweepRadar(const RadarCoast& coast, std::span<const RadarObject> objects, NorthEast antenna,
                const RadarSet& set, std::size_t first, std::size_t count, std::uint32_t seed,
                RadarPicture& picture) {
    if (picture.range_m <= 0.0) return;
    const auto halfBeam =
        static_cast<std::size_t>(std::max(0.0, 0.5 * set.beamWidth_rad / RadarPicture::kStep_rad));
    Sweep sweep(coast, antenna, set, picture.range_m, seed);
    std::vector<Ray> rays;
    for (std::size_t done = 0; done < count; done += kBatch) {
        const std::size_t batch = std::min(kBatch, count - done);
        rays.resize(batch + 2 * halfBeam);
        const std::size_t begin = first + done;
        sweep.run(static_cast<std::int64_t>(begin) - static_cast<std::int64_t>(halfBeam), rays, objects);
        for (std::size_t i = 0; i < batch; ++i) {
            std::uint8_t* const out =
                &picture.levels[(begin + i) % RadarPicture::kAzimuths * RadarPicture::kCells];
            std::copy(rays[i].levels.begin(), rays[i].levels.end(), out);
            for (std::size_t k = 1; k <= 2 * halfBeam; ++k)
                for (std::size_t cell = 0; cell < kCells; ++cell)
                    out[cell] = std::max(out[cell], rays[i + k].levels[cell]);
        }
    }
}

}  // namespace sagara::core
