#include "core/world/Bank.h"

#include <algorithm>
#include <cmath>

namespace sagara::core {
namespace {

constexpr double kOut = 10.0;  // beams
constexpr int kSamples = 12;   // on each side, their distances in geometric order

}  // namespace

double bankAsymmetry(const Area& area, NorthEast position, double heading_rad, double length_m, double beam_m,
                     double depth_m, double tide_m) {
    if (depth_m <= 0.0) return 0.0;
    const HeadingFrame frame(position, heading_rad);
    const double ratio = std::pow(2.0 * kOut, 1.0 / kSamples);
    double sum = 0.0;
    for (const double station : {-0.3, 0.0, 0.3}) {
        double near_m = 0.5 * beam_m;
        for (int i = 0; i < kSamples; ++i, near_m *= ratio) {
            const double far_m = near_m * ratio, middle_m = 0.5 * (near_m + far_m);
            const auto filled = [&](double y_m) {
                const double there_m = area.depth_m(frame.point({station * length_m, y_m})) + tide_m;
                return std::clamp(1.0 - there_m / depth_m, 0.0, 1.0);
            };
            sum += (filled(middle_m) - filled(-middle_m)) * (1.0 / near_m - 1.0 / far_m);
        }
    }
    return 0.5 * beam_m * sum / 3.0;
}

}  // namespace sagara::core
