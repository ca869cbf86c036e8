#include "core/world/Bank.h"

#include <gtest/gtest.h>

#include <functional>

#include "core/base/Units.h"

namespace sagara::core {
namespace {

constexpr double kLength_m = 200.0, kBeam_m = 30.0, kDepth_m = 15.0;

/// Water whose depth depends on the distance east of a line alone.
Area channel(const std::function<double(double)>& depth_m) {
    constexpr std::size_t kNodes = 1001;
    std::vector<float> values(2 * kNodes);
    for (std::size_t i = 0; i < kNodes; ++i)
        values[i] = values[kNodes + i] = static_cast<float>(depth_m(static_cast<double>(i) - 500.0));
    std::vector<float> square;
    for (std::size_t row = 0; row < kNodes; ++row)
        square.insert(square.end(), values.begin(), values.begin() + kNodes);
    Area area;
    area.depths.emplace_back(NorthEast{-500.0, -500.0}, 1.0, kNodes, kNodes, std::move(square));
    return area;
}
double eta(const Area& area, double east_m, double heading_rad = 0.0) {
    return bankAsymmetry(area, {0.0, east_m}, heading_rad, kLength_m, kBeam_m, kDepth_m, 0.0);
}

TEST(Bank, AWallIsNorrbinsWall) {
    const Area area = channel([](double east) { return std::abs(east) < 90.0 ? kDepth_m : -5.0; });
    const double exact = 0.5 * kBeam_m * (1.0 / 60.0 - 1.0 / 120.0);
    EXPECT_NEAR(eta(area, 30.0) / exact, 1.0, 0.2);  // twelve samples to either side
    EXPECT_NEAR(eta(area, 0.0), 0.0, 1e-9);          // the centreline
    EXPECT_NEAR(eta(area, -30.0), -eta(area, 30.0), 1e-6);
    EXPECT_NEAR(eta(area, 30.0, kPi), -eta(area, 30.0), 1e-6);  // heading the other way it is to port
}

TEST(Bank, ASlopeAndASubmergedBankDrawLessThanAWall) {
    const Area wall = channel([](double east) { return east < 90.0 ? kDepth_m : -5.0; });
    const Area slope =
        channel([](double east) { return std::min(kDepth_m, kDepth_m - 0.2 * (east - 90.0)); });
    const Area shelf = channel([](double east) { return east < 90.0 ? kDepth_m : 5.0; });
    EXPECT_GT(eta(wall, 40.0), eta(slope, 40.0));
    EXPECT_GT(eta(wall, 40.0), eta(shelf, 40.0));
    EXPECT_GT(eta(slope, 40.0), 0.0);
    EXPECT_GT(eta(shelf, 60.0), eta(shelf, 40.0));  // nearer is stronger
    EXPECT_EQ(eta(channel([](double) { return kDepth_m; }), 0.0), 0.0);
}

}  // namespace
}  // namespace sagara::core
