#include "ui/chart/ScaleBar.h"

#include <array>

#include "core/base/Units.h"

namespace sagara::chart {

double scaleBarPart_cables(double longest_m) {
    constexpr std::array<double, 11> kParts{0.05, 0.1, 0.25, 0.5, 1, 2.5, 5, 10, 20, 50, 100};
    double best = kParts.front();
    for (const double part : kParts) {
        if (part * core::kCable_m <= longest_m) best = part;
    }
    return best;
}

}  // namespace sagara::chart
