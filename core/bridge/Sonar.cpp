#include "core/bridge/Sonar.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "core/bridge/EchoSounder.h"
#include "core/bridge/SensorNoise.h"

namespace sagara::core {
namespace {

constexpr double kSource_dB = 90.0;       ///< of the bottom at 1 m over the noise
constexpr double kHullSource_dB = 110.0;  ///< of a side of 1 m2
constexpr double kAbsorption_dBpm = 0.02;
constexpr double kQuiet_mps = 8.0 * kKnot_mps;
constexpr double kFlow_dBpmps = 1.5 / kKnot_mps;

double flow_dB(double speed_mps) { return kFlow_dBpmps * std::max(0.0, std::abs(speed_mps) - kQuiet_mps); }

std::uint8_t levelOf(double over_dB) {
    return over_dB <= 0.0 ? 0 : static_cast<std::uint8_t>(std::min(255.0, 70.0 + 7.0 * over_dB));
}

struct Pinger {
    const Area& area;
    const ShipMotion& motion;
    NorthEast at;
    double depth_m;  ///< of the transducer
    double tide_m;
    std::uint32_t seed;
    SonarPicture& picture;
    double noise_dB(std::size_t beam, std::size_t cell) const {
        return 6.0 *
               (sensorNoise(seed, static_cast<std::uint32_t>(beam), static_cast<std::uint32_t>(cell / 2)) -
                0.5);
    }

    /// The bottom along one beam: what rises in front hides what lies behind it.
    std::array<float, SonarPicture::kCells> castBottom(std::size_t beam) {
        const NorthEast direction = unitVector(motion.heading_rad + SonarPicture::beam_rad(beam));
        const double cell_m = picture.cell_m();
        std::array<float, SonarPicture::kCells> hidden{};
        double lowest = 1e9, before_m = area.depth_m(at) + tide_m - depth_m;
        for (std::size_t cell = 0; cell < SonarPicture::kCells; ++cell) {
            const double range_m = (static_cast<double>(cell) + 0.5) * cell_m;
            hidden[cell] = static_cast<float>(lowest);
            const double water_m = area.depth_m(at + range_m * direction) + tide_m;
            const double below_m = water_m - depth_m;
            const double down = std::atan2(below_m, range_m);
            const double rise = std::atan2(before_m - below_m, cell_m);
            before_m = below_m;
            if (down > lowest) continue;
            lowest = down;
            const double over_dB =
                bottomEcho_dB(range_m, std::clamp(std::max(0.0, down) + rise, 0.0, 0.5 * kPi),
                              motion.surge_mps) +
                noise_dB(beam, cell);
            if (over_dB <= 0.0) continue;
            picture.levels[picture.index(beam, cell)] = levelOf(over_dB);
            picture.bottom_m[picture.index(beam, cell)] = static_cast<float>(water_m);
            if (water_m <= 0.0) lowest = -1e9;  // nothing is heard behind what comes out of the water
        }
        return hidden;
    }

    struct Hit {
        std::size_t beam, cell;
        double range_m, bearing_rad;
    };
    std::optional<Hit> place(NorthEast p) const {
        const double range_m = distance(at, p);
        const double bearing = wrapPi(bearing_rad(at, p) - motion.heading_rad);
        if (range_m >= picture.range_m || std::abs(bearing) > SonarPicture::kHalfSector_rad) return {};
        const double beam = bearing / kDegree_rad + 0.5 * static_cast<double>(SonarPicture::kBeams - 1);
        return Hit{static_cast<std::size_t>(std::lround(beam)),
                   std::min(SonarPicture::kCells - 1, static_cast<std::size_t>(range_m / picture.cell_m())),
                   range_m, bearing};
    }

    void castHull(const SonarObject& hull,
                  const std::vector<std::array<float, SonarPicture::kCells>>& hidden) {
        const HeadingFrame frame(hull.position, hull.heading_rad);
        const int steps = std::clamp(static_cast<int>(hull.length_m / picture.cell_m()) + 1, 4, 200);
        std::optional<SonarPicture::Contact> nearest;
        for (int i = 0; i <= steps; ++i)
            for (const double side : {-0.5, 0.0, 0.5}) {
                const double x_m = hull.length_m * (static_cast<double>(i) / steps - 0.5);
                const auto hit = place(frame.point({x_m, side * hull.beam_m}));
                if (!hit) continue;
                const double lowest = static_cast<double>(hidden[hit->beam][hit->cell]);
                if (lowest < -1.0) continue;  // behind land
                const double over_dB =
                    hullEcho_dB(hit->range_m, hull.length_m, hull.draught_m, motion.surge_mps) +
                    noise_dB(hit->beam, hit->cell);
                if (over_dB <= 0.0) continue;
                const std::size_t index = picture.index(hit->beam, hit->cell);
                picture.levels[index] = std::max(picture.levels[index], levelOf(over_dB));
                picture.contacts[index] = std::max(picture.contacts[index], levelOf(over_dB));
                if (!nearest || hit->range_m < nearest->range_m)
                    nearest = SonarPicture::Contact{hit->range_m, hit->bearing_rad, hull.draught_m};
            }
        if (nearest) picture.found.push_back(*nearest);
    }
};

}  // namespace

Sonar sonarOf(const Vessel& vessel) { return {{0.45 * vessel.hull.lengthBp_m, 0.0}, vessel.hull.draught_m}; }

double bottomEcho_dB(double range_m, double grazing_rad, double speed_mps) {
    return kSource_dB + 20.0 * std::log10(std::max(1e-3, std::sin(grazing_rad))) -
           30.0 * std::log10(std::max(1.0, range_m)) - 2.0 * kAbsorption_dBpm * range_m - flow_dB(speed_mps);
}

double hullEcho_dB(double range_m, double length_m, double draught_m, double speed_mps) {
    return kHullSource_dB + 10.0 * std::log10(std::max(0.1, length_m * draught_m)) -
           40.0 * std::log10(std::max(1.0, range_m)) - 2.0 * kAbsorption_dBpm * range_m - flow_dB(speed_mps);
}

SonarPicture ping(const Area& area, std::span<const SonarObject> objects, const Sonar& sonar,
                  const ShipMotion& motion, double tide_m, double range_m, std::uint32_t seed) {
    SonarPicture picture;
    picture.range_m = range_m;
    Pinger pinger{area,
                  motion,
                  HeadingFrame(motion.position(), motion.heading_rad).point(sonar.transducer),
                  transducerDepth_m(sonar.transducer, sonar.draught_m, motion),
                  tide_m,
                  seed,
                  picture};
    std::vector<std::array<float, SonarPicture::kCells>> hidden;
    for (std::size_t beam = 0; beam < SonarPicture::kBeams; ++beam) hidden.push_back(pinger.castBottom(beam));
    for (const SonarObject& object : objects) pinger.castHull(object, hidden);
    return picture;
}

std::optional<double> shoalAhead_m(const SonarPicture& picture, double depth_m, double within_rad) {
    for (std::size_t cell = 0; cell < SonarPicture::kCells; ++cell)
        for (std::size_t beam = 0; beam < SonarPicture::kBeams; ++beam) {
            if (std::abs(SonarPicture::beam_rad(beam)) > within_rad) continue;
            const float bottom_m = picture.bottom_m[picture.index(beam, cell)];
            if (static_cast<double>(bottom_m) < depth_m)  // false where unseen
                return (static_cast<double>(cell) + 0.5) * picture.cell_m();
        }
    return std::nullopt;
}

}  // namespace sagara::core
