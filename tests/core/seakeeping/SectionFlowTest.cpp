#include "core/seakeeping/SectionFlow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/Units.h"
#include "core/seakeeping/SectionShape.h"
#include "core/seakeeping/WaveSource.h"
#include "tests/support/ReferenceCsv.h"

namespace sagara::core {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

std::vector<SectionPanel> semicircle(int panels) {
    return panelsOf(*lewisSection({1.0, 1.0, 0.5 * kPi, 4.0 / (3.0 * kPi)}, panels));
}

std::vector<SectionPanel> sectionOf(const std::string& name) {
    if (name == "semicircle") return semicircle(24);
    if (name.starts_with("rectangle")) return panelsOf(shapeOf({1.0, 1.0, 2.0, 0.5}, 24).nodes);
    return panelsOf(lewisSection({1.337, 1.0, 0.966 * 2.674, 0.48}, 24).value());
}

TEST(SectionFlow, CoefficientsAreThoseOfTheReference) {
    for (const test::Row& row : test::readReference("seakeeping/sections_2d_check.csv")) {
        const std::string name = row.text("section");
        const std::vector<SectionPanel> panels = sectionOf(name);
        const double tolerance = name.starts_with("rectangle") ? 0.06 : 0.03;
        const double half_m = panels.back().to.y_m, nu = row["xi"] / half_m;
        const double area_m2 = areaOf(panels).area_m2, root = std::sqrt(row["xi"]);
        const SectionRadiation r = radiationOf(panels, flowAbout(panels, nu));
        const std::string where = name + " at " + row.text("xi");
        EXPECT_NEAR(r.addedMass.heave_m2 / area_m2, row["a33"], tolerance * row["a33"]) << where;
        EXPECT_NEAR(r.addedMass.sway_m2 / area_m2, row["a22"], tolerance * row["a22"] + 0.004) << where;
        EXPECT_NEAR(r.dampingOverOmega.sway_m2 / area_m2 * root, row["b22"], tolerance * row["b22"]) << where;
        // Heave's damping falls to nothing at high frequency: by the waves it makes.
        const double waves = std::sqrt(std::max(r.dampingOverOmega.heave_m2, 0.0) * nu * nu);
        EXPECT_NEAR(waves, row["Abar"], 0.02) << where;
    }
}

TEST(SectionFlow, SemicircleHasItsExactLimits) {
    const auto panels = semicircle(40);
    const double area_m2 = 0.5 * kPi;
    EXPECT_NEAR(radiationOf(panels, flowAbout(panels, kInfinite)).addedMass.heave_m2 / area_m2, 1.0, 0.005);
    EXPECT_NEAR(radiationOf(panels, flowAbout(panels, kInfinite)).addedMass.sway_m2 / area_m2,
                4.0 / (kPi * kPi), 0.005);
    EXPECT_NEAR(radiationOf(panels, flowAbout(panels, 0.0)).addedMass.sway_m2 / area_m2, 1.0, 0.005);
    // Low: the waves made are those of a wavemaker with the breadth, B w^2 / g.
    const SectionRadiation slow = radiationOf(panels, flowAbout(panels, 0.001));
    EXPECT_NEAR(std::sqrt(slow.dampingOverOmega.heave_m2) * 0.001, 2.0 * 0.001, 1e-5);
}

TEST(SectionFlow, ACircleThatRollsMovesNoWater) {
    const auto panels = semicircle(24);
    const SectionRadiation r = radiationOf(panels, flowAbout(panels, 1.0));
    EXPECT_NEAR(r.addedMass.roll_m4, 0.0, 1e-4);
    EXPECT_NEAR(r.addedMass.swayRoll_m3, 0.0, 1e-4);
}

TEST(SectionFlow, NoIrregularFrequencyShows) {
    // Close fit without inner points breaks down about here for a box of this breadth.
    const auto panels = sectionOf("rectangle");
    double before = radiationOf(panels, flowAbout(panels, 1.0)).addedMass.heave_m2;
    for (double nu = 1.02; nu < 8.0; nu += 0.02) {
        const double now = radiationOf(panels, flowAbout(panels, nu)).addedMass.heave_m2;
        ASSERT_NEAR(now, before, 0.01 * before) << nu;
        before = now;
    }
}

TEST(SectionFlow, AKeelTooThinForPanelsSwaysAsAPlate) {
    // Zero thickness at the keel. A plate of unit draught: pi / 2 at low frequency (its double in endless
    // water).
    std::vector<SectionPoint> cusp;
    for (int i = 0; i <= 20; ++i) cusp.push_back({0.1 * std::pow(i / 20.0, 2), i / 20.0 - 1.0});
    const auto panels = panelsOf(thickened(cusp));
    EXPECT_NEAR(radiationOf(panels, flowAbout(panels, 0.01)).addedMass.sway_m2, 0.5 * kPi, 0.1 * 0.5 * kPi);
    for (const double nu : {0.3, 1.0, 3.0, 10.0}) {
        const SectionRadiation r = radiationOf(panels, flowAbout(panels, nu));
        EXPECT_GT(r.addedMass.sway_m2, 0.2) << nu;
        EXPECT_GT(r.dampingOverOmega.sway_m2, 0.0) << nu;
    }
}

TEST(SectionFlow, TwiceThePanelsChangeLittle) {
    for (const double nu : {0.2, 1.0, 4.0}) {
        const auto coarse = semicircle(20), fine = semicircle(40);
        const SectionRadiation a = radiationOf(coarse, flowAbout(coarse, nu)),
                               b = radiationOf(fine, flowAbout(fine, nu));
        EXPECT_NEAR(a.addedMass.heave_m2, b.addedMass.heave_m2, 0.01 * b.addedMass.heave_m2);
        EXPECT_NEAR(a.addedMass.sway_m2, b.addedMass.sway_m2, 0.015 * b.addedMass.sway_m2);
    }
}

TEST(WaveSource, SeriesAndAsymptoteMeet) {
    for (double angle = 0.5 * kPi; angle <= 1.5 * kPi; angle += 0.1) {
        const std::complex<double> in = std::polar(12.0 - 1e-9, angle), out = std::polar(12.0 + 1e-9, angle);
        EXPECT_NEAR(std::abs(waveIntegral(in) - waveIntegral(out)), 0.0, 2e-5) << angle;
    }
}

TEST(SectionShape, ShapesMeetTheirData) {
    // A bulb and a skeg of S175, a full section of KVLCC2, a fine one.
    const std::vector<SectionData> all{{0.105, 9.37, 13.8798, 5.961},
                                       {4.46, 9.5, 23.435, 2.7705},
                                       {29.0, 20.8, 1203.93, 10.416},
                                       {3.0, 6.0, 22.0, 2.4}};
    const std::vector<SectionFit> fits{SectionFit::Bulb, SectionFit::Skeg, SectionFit::RoundedBox,
                                       SectionFit::Lewis};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const SectionShape shape = shapeOf(all[i], 30);
        EXPECT_EQ(shape.fit, fits[i]) << i;
        const SectionArea area = areaOf(panelsOf(shape.nodes));
        EXPECT_NEAR(area.area_m2, all[i].area_m2, 0.01 * all[i].area_m2) << i;
        EXPECT_NEAR(area.depth_m, all[i].centroidDepth_m, kCentroidBand * all[i].draught_m) << i;
        EXPECT_NEAR(shape.nodes.back().y_m, all[i].halfBreadth_m, 1e-9) << i;
        EXPECT_NEAR(shape.nodes.front().z_m, -all[i].draught_m, 1e-9) << i;
    }
}

}  // namespace
}  // namespace sagara::core
