#include "render/scene/ogre/WaterMap.h"

#include <algorithm>
#include <cmath>

#include "render/scene/ogre/Buffers.h"

namespace sagara::render {
namespace {

constexpr double kDeepest_m = 60.0;  ///< of the green
/// Depths of the table between which waves are taken as those of the nearest.
constexpr double kShallowest_m = -3.0, kStep_m = 0.1;
constexpr std::size_t kSteps = 630;

std::uint32_t byteOf(double share) {
    return static_cast<std::uint32_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

std::size_t stepOf(double depth_m) {
    const double place = std::round((depth_m - kShallowest_m) / kStep_m);
    return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(kSteps - 1)));
}

}  // namespace

WaterMap::WaterMap(const std::string& name, const core::Area& area, std::size_t index)
    : m_shoaling(area.shoaling) {
    const std::vector<core::Grid>& grids = area.shelter.empty() ? area.depths : area.shelter;
    if (grids.empty() || (area.shelter.empty() && !area.shoaling)) {
        m_shelter.assign(4, 1.0F);
        m_depth_m.assign(4, 0.5F * static_cast<float>(kDeepest_m));
    } else {
        const core::Grid& grid = grids[std::min(index, grids.size() - 1)];
        const double spacing_m = grid.spacing_m(),
                     half = 0.5 * spacing_m;  // a node is the middle of its pixel
        m_rows = grid.rows();
        m_columns = grid.columns();
        m_southWest = grid.southWest() - core::NorthEast{half, half};
        m_east_m = spacing_m * static_cast<double>(m_columns);
        m_north_m = spacing_m * static_cast<double>(m_rows);
        for (std::size_t row = 0; row < m_rows; ++row) {
            for (std::size_t column = 0; column < m_columns; ++column) {
                const core::NorthEast p = grid.node(row, column);
                m_shelter.push_back(static_cast<float>(area.shelterFactor(p)));
                m_depth_m.push_back(static_cast<float>(area.depth_m(p)));
            }
        }
    }
    m_texture = byteTexture(name, static_cast<int>(m_columns), static_cast<int>(m_rows),
                            pixels(core::LocalWaves(area, {}, 0.0)));
}

std::vector<std::uint32_t> WaterMap::pixels(const core::LocalWaves& waves) const {
    std::vector<core::LocalWaves::OfDepth> ofDepth;
    ofDepth.reserve(kSteps);
    for (std::size_t i = 0; i < kSteps; ++i)
        ofDepth.push_back(waves.ofDepth(kShallowest_m + kStep_m * static_cast<double>(i)));
    std::vector<std::uint32_t> pixels(m_shelter.size());
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const double depth_m = static_cast<double>(m_depth_m[i]);
        const double factor = waves.factor(static_cast<double>(m_shelter[i]), ofDepth[stepOf(depth_m)]);
        pixels[i] =
            byteOf(factor / core::LocalWaves::kMostFactor) | byteOf(depth_m / kDeepest_m) << 8 | 0xff000000U;
    }
    return pixels;
}

void WaterMap::follow(const core::LocalWaves& waves, double tide_m) {
    if (!m_shoaling) return;
    const Shown now{waves.significantHeight_m(), waves.peakPeriod_s(), tide_m};
    const auto like = [](double a, double b, double share) { return std::abs(a - b) <= share * b; };
    constexpr double kTide_m = 0.05;
    if (m_shown && like(now.height_m, m_shown->height_m, 0.02) &&
        like(now.period_s, m_shown->period_s, 0.01) && std::abs(now.tide_m - m_shown->tide_m) <= kTide_m)
        return;
    m_shown = now;
    upload(m_texture, pixels(waves));
}

Ogre::Vector4 WaterMap::place(core::NorthEast p) const {
    const core::NorthEast d = p - m_southWest;
    return {static_cast<float>(d.east_m / m_east_m), static_cast<float>(d.north_m / m_north_m),
            static_cast<float>(1.0 / m_east_m), static_cast<float>(1.0 / m_north_m)};
}

}  // namespace sagara::render
