#include "ui/chart/Contours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <set>

#include "core/base/Random.h"
#include "core/base/Shapes.h"
#include "core/base/Units.h"
#include "tests/support/Assets.h"
#include "ui/chart/Polyline.h"

namespace sagara::chart {
namespace {

using core::NorthEast;
using Line = std::vector<NorthEast>;

template <typename Depth>
core::Grid gridOf(NorthEast southWest, double spacing_m, std::size_t rows, std::size_t columns,
                  Depth&& depth) {
    std::vector<float> values;
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            const NorthEast p = southWest + NorthEast{spacing_m * static_cast<double>(row),
                                                      spacing_m * static_cast<double>(column)};
            values.push_back(static_cast<float>(depth(p)));
        }
    }
    return {southWest, spacing_m, rows, columns, std::move(values)};
}

core::Area galle() {
    auto loaded = core::loadArea("area.json", sagara::test::readAsset("areas/galle/area.json"));
    if (!loaded) throw std::runtime_error(loaded.error().text());
    return std::move(loaded).value();
}

bool crossesAny(const std::vector<Line>& lines, NorthEast a, NorthEast b) {
    for (const Line& line : lines) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            if (core::crosses({line[i - 1], line[i]}, a, b)) return true;
        }
    }
    return false;
}

TEST(Contours, AConeGivesOneClosedCirclePerDepth) {
    const core::Grid cone =
        gridOf({-500, -500}, 10, 101, 101, [](NorthEast p) { return core::length(p) / 10.0; });
    for (const double depth_m : {5.0, 12.3, 40.0}) {
        const auto lines = contourLines(cone, depth_m);
        ASSERT_EQ(lines.size(), 1u) << depth_m;
        EXPECT_EQ(lines[0].front(), lines[0].back());
        // a chord of the cell's size leaves a cone by less than its square over 8 radii, and the line was
        // simplified by a twentieth of the spacing
        const double tolerance_m = 10.0 * 10.0 * 2.0 / (8.0 * 10.0 * depth_m) + 0.5;
        for (const NorthEast p : lines[0])
            EXPECT_NEAR(core::length(p), 10.0 * depth_m, tolerance_m) << depth_m;
    }
}

TEST(Contours, ASlopeGivesOneStraightOpenLine) {
    const core::Grid slope = gridOf({0, 0}, 20, 30, 40, [](NorthEast p) { return 0.1 * p.east_m; });
    const auto lines = contourLines(slope, 33.3);
    ASSERT_EQ(lines.size(), 1u);
    ASSERT_EQ(lines[0].size(), 2u) << "a straight line keeps its ends only";
    for (const NorthEast p : lines[0]) EXPECT_NEAR(p.east_m, 333.0, 1e-3);  // the values are floats
    EXPECT_NEAR(core::distance(lines[0][0], lines[0][1]), 20.0 * 29, 1e-9);
}

TEST(Contours, NothingWhereTheValueDoesNotOccur) {
    const core::Grid flat = gridOf({0, 0}, 1, 5, 5, [](NorthEast) { return 7.0; });
    EXPECT_TRUE(contourLines(flat, 6.9).empty());
    EXPECT_TRUE(contourLines(flat, 7.0).empty()) << "all of it counts as deeper";
    EXPECT_TRUE(contourLines(flat, 7.1).empty());
}

TEST(Contours, AValueOnTheNodesGivesNoPointTwice) {
    const core::Grid steps =
        gridOf({0, 0}, 10, 20, 20, [](NorthEast p) { return std::round(p.north_m / 30.0); });
    for (const Line& line : contourLines(steps, 3.0)) {
        for (std::size_t i = 1; i < line.size(); ++i) EXPECT_GT(core::distance(line[i - 1], line[i]), 1e-6);
    }
}

TEST(Contours, ASaddleIsSplitTheWayItsMeanSays) {
    const core::Grid deepMiddle({0, 0}, 1, 2, 2, {9, 4, 4, 9});
    for (const Line& line : contourLines(deepMiddle, 5.0)) {
        for (const NorthEast p : line)
            EXPECT_GT(std::abs(p.north_m - p.east_m), 0.2) << "the deep corners hang together";
    }
    EXPECT_EQ(contourLines(deepMiddle, 5.0).size(), 2u);
    EXPECT_EQ(contourLines(deepMiddle, 8.0).size(), 2u);
}

/// Every crossing of a line with a cell edge is found once: random ground, all lines together.
TEST(Contours, RandomGroundHasNoSegmentTwiceAndNoLooseEndInside) {
    core::Random random(7);
    std::vector<float> values(60 * 50);
    for (float& v : values) v = static_cast<float>(random.uniform());
    const core::Grid ground({0, 0}, 10, 60, 50, values);
    std::set<std::array<double, 4>> seen;
    for (const Line& line : contourLines(ground, 0.5)) {
        for (std::size_t i = 1; i < line.size(); ++i) {
            const std::array<double, 4> ahead{line[i - 1].north_m, line[i - 1].east_m, line[i].north_m,
                                              line[i].east_m};
            const std::array<double, 4> back{ahead[2], ahead[3], ahead[0], ahead[1]};
            EXPECT_TRUE(seen.insert(std::min(ahead, back)).second);
        }
        if (line.front() == line.back()) continue;
        for (const NorthEast end : {line.front(), line.back()}) {
            const bool onBorder =
                end.north_m == 0.0 || end.east_m == 0.0 || end.north_m == 590.0 || end.east_m == 490.0;
            EXPECT_TRUE(onBorder) << end.north_m << " " << end.east_m;
        }
    }
}

TEST(Contours, GalleTenMetreLinePassesBetweenNineAndElevenMetres) {
    const core::Area area = galle();
    const auto contours = contoursOf(area, std::array{10.0});
    ASSERT_EQ(contours.size(), 1u);
    core::Random random(1);
    std::size_t pairs = 0;
    for (int i = 0; i < 20000; ++i) {
        const NorthEast a{-4000.0 + 5500.0 * random.uniform(), -4500.0 + 6000.0 * random.uniform()};
        const NorthEast b = a + 500.0 * random.uniform() * core::unitVector(core::kTwoPi * random.uniform());
        const bool nine = std::abs(area.depth_m(a) - 9.0) < 0.3,
                   eleven = std::abs(area.depth_m(b) - 11.0) < 0.3;
        if (!nine || !eleven) continue;
        ++pairs;
        EXPECT_TRUE(crossesAny(contours[0].lines, a, b)) << a.north_m << " " << a.east_m;
    }
    EXPECT_GT(pairs, 20u);
}

TEST(Contours, EveryPointOfGalleLinesHasItsDepth) {
    const core::Area area = galle();
    for (const Contour& contour : contoursOf(area, std::array{5.0, 15.0})) {
        for (const Line& line : contour.lines) {
            for (const NorthEast p : line) {
                if (area.isLand(p)) continue;  // steep there, and hidden
                // exact on a cell's edge; where the finer grid begins the two differ by what the coarse one
                // smooths away
                EXPECT_NEAR(area.depth_m(p), contour.depth_m, 1.0);
            }
        }
    }
}

/// Odd-even: how many rings go round a point.
bool inside(const std::vector<Line>& rings, NorthEast p) {
    return std::count_if(rings.begin(), rings.end(), [&](const Line& r) { return core::contains(r, p); }) %
               2 ==
           1;
}

TEST(Contours, RingsHoldWhatIsDeeperAndNothingElse) {
    core::Random random(11);
    std::vector<float> values(20 * 30);
    for (float& v : values) v = static_cast<float>(random.uniform());
    const core::Grid ground({-40, 70}, 10, 20, 30, values);
    const auto rings = deeperThan(ground, 0.5);
    for (const Line& ring : rings) EXPECT_EQ(ring.front(), ring.back());
    for (std::size_t row = 1; row + 1 < ground.rows(); ++row) {
        for (std::size_t column = 1; column + 1 < ground.columns(); ++column) {
            const NorthEast p = ground.node(row, column);
            if (std::abs(ground.at(p) - 0.5) < 0.1) continue;  // lines are simplified by half a metre
            EXPECT_EQ(inside(rings, p), ground.at(p) > 0.5) << row << " " << column;
        }
    }
}

TEST(Contours, AGridDeepThroughoutIsOneRingAlongItsEdge) {
    const core::Grid flat = gridOf({0, 0}, 10, 5, 5, [](NorthEast) { return 7.0; });
    const auto rings = deeperThan(flat, 5.0);
    ASSERT_EQ(rings.size(), 1u);
    for (const NorthEast p : rings[0]) {
        EXPECT_TRUE(p.north_m > -0.01 && p.north_m < 40.01 && p.east_m > -0.01 && p.east_m < 40.01);
    }
    EXPECT_TRUE(inside(rings, {1, 39}));
    EXPECT_TRUE(deeperThan(flat, 8.0).empty());
}

TEST(Contours, GalleTakesLessThanAThirdOfASecond) {
    const core::Area area = galle();
    const std::array depths_m{2.0, 5.0, 10.0, 15.0, 20.0, 30.0, 50.0};
    const auto began = std::chrono::steady_clock::now();
    const auto contours = contoursOf(area, depths_m);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    EXPECT_EQ(contours.size(), depths_m.size());
    RecordProperty("milliseconds", static_cast<int>(1000.0 * took.count()));
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    EXPECT_LT(took.count(), 10.0);
#else
    EXPECT_LT(took.count(), 0.3);
#endif
}

TEST(Polyline, SimplifyingKeepsTheEndsAndTheTolerance) {
    Line wave;
    for (int i = 0; i <= 1000; ++i) wave.push_back({10.0 * std::sin(0.02 * i), 1.0 * i});
    const Line thin = simplified(wave, 0.5);
    EXPECT_LT(thin.size(), 80u);
    EXPECT_EQ(thin.front(), wave.front());
    EXPECT_EQ(thin.back(), wave.back());
    for (const NorthEast p : wave) {
        double nearest_m = 1e9;
        for (std::size_t i = 1; i < thin.size(); ++i)
            nearest_m = std::min(nearest_m, core::distanceTo({thin[i - 1], thin[i]}, p));
        EXPECT_LE(nearest_m, 0.5);
    }
}

TEST(Polyline, ShortLinesStayAsTheyAre) {
    EXPECT_TRUE(simplified(Line{}, 1.0).empty());
    EXPECT_EQ(simplified(Line{{1, 2}}, 1.0).size(), 1u);
    EXPECT_EQ(simplified(Line{{1, 2}, {1, 2}}, 1.0).size(), 2u);
}

}  // namespace
}  // namespace sagara::chart
