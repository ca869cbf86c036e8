#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "render/scene/ship/HullSurface.h"
#include "tests/support/Assets.h"

namespace sagara::render {
namespace {

/// KVLCC2 as a document would have her: freeboard and length overall are not in the reference file.
ShipForm kvlcc2() {
    const auto file =
        nlohmann::json::parse(sagara::test::readFile(SAGARA_TEST_DATA "/seakeeping/kvlcc2_hull.json"));
    ShipForm form;
    form.style = ShipStyle::Tanker;
    form.length_m = 335.0;
    form.beam_m = file["breadth_m"];
    form.draught_m = file["draught_m"];
    form.freeboard_m = 9.2;
    form.block = 0.81;
    for (const auto& row : file["stations"])
        form.stations.push_back({row[0], row[1], row[2], row[3], row[4]});
    return form;
}

/// Starboard points of the shell at a station, from the keel to the waterline.
std::vector<Point> sectionAt(const Solid& hull, double x) {
    std::vector<Point> section;
    for (const SolidVertex& v : hull.vertices) {
        const Point p = v.position;
        const bool known =
            std::any_of(section.begin(), section.end(), [&](Point q) { return q.up == p.up && q.y == p.y; });
        if (p.x == x && p.y >= 0.0 && p.up <= 0.0 && !known) section.push_back(p);
    }
    std::sort(section.begin(), section.end(), [](Point a, Point b) { return a.up < b.up; });
    return section;
}

TEST(HullStations, TheShellHasTheBreadthAndDraughtOfEveryStation) {
    const ShipForm form = kvlcc2();
    const Solid hull = hullSurface(form, {});
    for (const core::HullStation& s : form.stations) {
        const std::vector<Point> section = sectionAt(hull, s.x_m);
        ASSERT_GE(section.size(), 5u) << s.x_m;
        EXPECT_EQ(section.back().up, 0.0);
        EXPECT_DOUBLE_EQ(section.back().y, 0.5 * s.breadth_m);
        EXPECT_DOUBLE_EQ(section.front().up, -s.draught_m);
    }
}

TEST(HullStations, TheShellFillsTheAreaOfEveryStation) {
    // Six points a side: the polygon lies inside the curve, by up to 6 % of the box at the sharp ends.
    const ShipForm form = kvlcc2();
    const Solid hull = hullSurface(form, {});
    for (const core::HullStation& s : form.stations) {
        const std::vector<Point> section = sectionAt(hull, s.x_m);
        double area_m2 = 0.0;
        for (std::size_t i = 0; i + 1 < section.size(); ++i)
            area_m2 += (section[i].y + section[i + 1].y) * (section[i + 1].up - section[i].up);
        EXPECT_NEAR(area_m2, s.area_m2, 0.06 * s.breadth_m * s.draught_m) << s.x_m;
    }
}

TEST(HullStations, TheDeckIsNowhereNarrowerThanTheWaterAndReachesBothEnds) {
    const ShipForm form = kvlcc2();
    for (const core::HullStation& s : form.stations)
        EXPECT_GE(deckHalfBreadth_m(form, s.x_m), 0.5 * s.breadth_m - 1e-9);
    double bow = 0.0, stern = 0.0, side = 0.0;
    for (const SolidVertex& v : hullSurface(form, {}).vertices) {
        ASSERT_TRUE(std::isfinite(v.position.x + v.position.y + v.position.up));
        bow = std::max(bow, v.position.x);
        stern = std::min(stern, v.position.x);
        side = std::max(side, v.position.y);
    }
    EXPECT_NEAR(bow, 0.5 * form.length_m, 0.01 * form.length_m);
    EXPECT_NEAR(stern, -0.5 * form.length_m, 0.02 * form.length_m);
    EXPECT_NEAR(side, 0.5 * form.beam_m, 0.01 * form.beam_m);
}

}  // namespace
}  // namespace sagara::render
