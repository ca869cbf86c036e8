#include "render/scene/sea/SeaTiles.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Random.h"
#include "core/sea/Beaufort.h"

namespace sagara::render {
namespace {

core::SeaState windSeaOf(const core::WaveTable& table, int beaufort) {
    core::SeaState sea{
        {*core::windSea(core::windOfBeaufort_mps(beaufort), 0.6, core::Exposure::Inshore)}, {}, {}};
    core::raiseSea(table, sea);
    return sea;
}

constexpr core::SimTime kTime{1'234'560'000};

TEST(SeaTiles, TheSurfaceDrawnIsTheSurfaceFelt) {
    const core::WaveTable table(7, 20.0);
    const core::SeaState sea = windSeaOf(table, 5);
    SeaTiles tiles(table);
    tiles.advance(sea, kTime);
    const core::SeaSurface surface(table, sea);
    core::Random random(3);
    double sum2 = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const core::NorthEast p{20'000.0 * (random.uniform() - 0.5), 20'000.0 * (random.uniform() - 0.5)};
        sum2 += std::pow(tiles.elevation_m(p) - surface.elevation_m(p, kTime), 2);
    }
    EXPECT_LT(std::sqrt(sum2 / 1000.0), 0.02);  // the figure asked for
}

TEST(SeaTiles, SignificantHeightIsWithin3Percent) {
    const core::WaveTable table(7, 20.0);
    for (const int beaufort : {3, 5, 7}) {
        const core::SeaState sea = windSeaOf(table, beaufort);
        SeaTiles tiles(table);
        double sum2 = 0.0, count = 0.0;
        for (int second = 0; second < 40; ++second) {
            tiles.advance(sea, core::SimTime::fromSeconds(97 * second));
            for (int i = 0; i < 40; ++i) {
                for (int j = 0; j < 40; ++j, ++count) {
                    const double z = tiles.elevation_m({31.7 * i, 29.3 * j});
                    sum2 += z * z;
                }
            }
        }
        EXPECT_NEAR(4.0 * std::sqrt(sum2 / count) / sea.systems[0].significantHeight_m, 1.0, 0.03)
            << beaufort;
    }
}

TEST(SeaTiles, SlopesAreThoseOfTheHeights) {
    const core::WaveTable table(7, 20.0);
    SeaTiles tiles(table);
    tiles.advance(windSeaOf(table, 5), kTime);
    const SeaTile& tile = tiles.tiles()[1];
    const int n = tile.height_m.sizes[0];
    const double step_m = tile.tile_m / n;
    const auto height = [&](int row, int column) {
        return static_cast<double>(
            tile.height_m.levels[0][static_cast<std::size_t>(((row + n) % n) * n + (column + n) % n)]);
    };
    double error2 = 0.0, slope2 = 0.0;
    for (int row = 0; row < n; ++row) {
        for (int column = 0; column < n; ++column) {
            const std::uint32_t s = tile.surface.levels[0][static_cast<std::size_t>(row * n + column)];
            const auto slope = [&](int shift) {
                return ((s >> shift & 0xff) / 127.5 - 1.0) * tile.slopeScale;
            };
            const double north = (height(row + 1, column) - height(row - 1, column)) / (2.0 * step_m);
            const double east = (height(row, column + 1) - height(row, column - 1)) / (2.0 * step_m);
            error2 += std::pow(slope(0) - north, 2) + std::pow(slope(8) - east, 2);
            slope2 += north * north + east * east;
        }
    }
    EXPECT_LT(std::sqrt(error2 / slope2), 0.15);  // the central difference loses a tenth of the short waves
}

TEST(SeaTiles, TwoProcessesDrawTheSameBytes) {
    const core::WaveTable table(7, 20.0), again(7, 20.0);
    SeaTiles a(table), b(again);
    b.advance(windSeaOf(again, 3), core::SimTime::fromSeconds(5));  // another past
    a.advance(windSeaOf(table, 6), kTime);
    b.advance(windSeaOf(again, 6), kTime);
    for (std::size_t band = 0; band < 3; ++band) {
        EXPECT_EQ(a.tiles()[band].height_m.levels, b.tiles()[band].height_m.levels);
        EXPECT_EQ(a.tiles()[band].surface.levels, b.tiles()[band].surface.levels);
    }
}

TEST(SeaTiles, CalmIsFlat) {
    const core::WaveTable table(7, 20.0);
    SeaTiles tiles(table);
    tiles.advance(core::SeaState{}, kTime);
    EXPECT_EQ(tiles.elevation_m({123.0, 456.0}), 0.0);
}

}  // namespace
}  // namespace sagara::render
