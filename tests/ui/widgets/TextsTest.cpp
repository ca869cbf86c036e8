#include <gtest/gtest.h>

#include <cmath>

#include "core/base/Random.h"
#include "core/base/Units.h"
#include "tests/ui/widgets/LessonScene.h"
#include "ui/widgets/AreaTexts.h"
#include "ui/widgets/ChartPalette.h"
#include "ui/widgets/ChartTexts.h"
#include "ui/widgets/ChartTools.h"
#include "ui/widgets/ToolLayer.h"

/// What the chart says and measures: no window is needed.
namespace sagara::ui::test {
namespace {

using core::NorthEast;

std::string of(const QString& text) { return text.toStdString(); }

TEST(ChartTexts, PositionsAreWrittenAsTheConsoleHasThem) {
    const core::LocalFrame& frame = galle()->area->frame;
    EXPECT_EQ(of(positionText(frame, frame.toLocal({6.0325, 80.2266667}))), "006°01.95'N 080°13.60'E");
    const core::LocalFrame south({-33.9, -0.001});
    EXPECT_EQ(of(positionText(south, {})), "033°54.00'S 000°00.06'W");
}

TEST(ChartTexts, RangesAreInMilesAndCables) {
    EXPECT_EQ(of(rangeBearingText({1.23 * core::kNauticalMile_m, 45.0 * core::kDegree_rad})),
              "045°T 1.23 M 12.3 cables");
    EXPECT_EQ(of(rangeBearingText({0.0, core::kTwoPi - 1e-6})), "000°T 0.00 M 0.0 cables");
}

TEST(ChartTexts, DepthsAreCutOffAndLandIsLand) {
    const PreparedChart& chart = *galle();
    const core::Area& area = *chart.area;
    EXPECT_EQ(of(depthText(chart, area.findPlace("fort")->position)), "land");
    EXPECT_EQ(of(depthText(chart, {0.0, -30000.0})), "no depth");
    const NorthEast p = area.findPlace("anch_ne_monsoon")->position;
    const double shown_m = depthText(chart, p).split(u' ').first().toDouble();
    EXPECT_LE(shown_m, area.depth_m(p));
    EXPECT_GT(shown_m, area.depth_m(p) - 0.1);
    EXPECT_EQ(of(depthText(*prepareChart(nullptr, 5.0), p)), "no depth");
}

TEST(ChartTexts, DepthsSayThatTheyAreModelledAndOfWhat) {
    EXPECT_TRUE(
        of(depthNote(*galle()->area)).starts_with("Modelled depths in metres below LAT. Source: 0.165 d"));
    core::Area surveyed;
    surveyed.depthDatum = "LAT";
    surveyed.depthSource = "survey of 2020";
    EXPECT_EQ(of(depthNote(surveyed)), "Depths in metres below LAT. Source: survey of 2020.");
}

TEST(ChartTexts, ClocksGoRoundAtMidnight) {
    EXPECT_EQ(of(clockText(9.0 * 3600.0 + 5.0 * 60.0 + 59.0)), "09:05");
    EXPECT_EQ(of(clockText(86400.0)), "00:00");
    EXPECT_EQ(of(clockText(-60.0)), "23:59");
}

TEST(ChartTexts, LightsReadAsTheLightListHasThem) {
    const core::Light light{"Fl(2) W 15s", 28.0, 18.0};
    EXPECT_EQ(of(lightText(light)), "Fl(2) W 15s 28m 18M");
    EXPECT_EQ(lightColour(light), LightColour::White);
    EXPECT_EQ(lightColour({"Fl R 5s", 0, 0}), LightColour::Red);
    EXPECT_EQ(lightColour({"Q(3) G 10s", 0, 0}), LightColour::Green);
    EXPECT_EQ(of(plainName("No. 1 (fictional)")), "No. 1");
}

TEST(Measure, AgreesWithGeodesyAboutTheDatumOfTheFrame) {
    // in frame N distances and bearings from its own datum are exact
    const core::LocalFrame& frame = galle()->area->frame;
    core::Random random(5);
    for (int i = 0; i < 50; ++i) {
        const NorthEast to{8000.0 * (random.uniform() - 0.5), 8000.0 * (random.uniform() - 0.5)};
        const RangeBearing measured = measure(frame, {}, to);
        EXPECT_NEAR(measured.distance_m, core::length(to), 1e-6);
        EXPECT_NEAR(std::remainder(measured.bearing_rad - core::bearing_rad({}, to), core::kTwoPi), 0.0,
                    1e-9);
    }
}

TEST(Measure, BearingsAreFromTrueNorthAwayFromTheDatum) {
    const core::LocalFrame frame({60.0, 10.0});
    const NorthEast from{0.0, 20000.0}, to{5000.0, 20000.0};
    const RangeBearing measured = measure(frame, from, to);
    EXPECT_NEAR(measured.distance_m, 5000.0, 0.1);
    // due north in the frame is less than north on the ground, by the convergence
    EXPECT_NEAR(std::remainder(measured.bearing_rad - trueDirection_rad(frame, from, 0.0), core::kTwoPi), 0.0,
                5e-6);
    EXPECT_GT(std::abs(std::remainder(measured.bearing_rad, core::kTwoPi)), 0.004);
}

TEST(ChartTools, ARangeFromTheOwnShipMovesWithHer) {
    ChartTools tools;
    tools.choose(ChartTools::Tool::RangeBearing);
    tools.beginRange({0, 0}, true);
    tools.drag({100, 0});
    tools.release();
    tools.ownShipAt({40, 0});
    EXPECT_EQ(tools.range()->from, (NorthEast{40, 0}));
    EXPECT_EQ(tools.range()->to, (NorthEast{100, 0}));
    tools.drag({7, 7});
    EXPECT_EQ(tools.range()->to, (NorthEast{100, 0})) << "let go is let go";
    EXPECT_TRUE(tools.cancel());
    EXPECT_FALSE(tools.range());
    EXPECT_EQ(tools.tool(), ChartTools::Tool::RangeBearing);
    EXPECT_TRUE(tools.cancel());
    EXPECT_EQ(tools.tool(), ChartTools::Tool::None);
    EXPECT_FALSE(tools.cancel());
}

TEST(ChartTools, ARuleKeepsItsDirectionWhileItIsDragged) {
    ChartTools tools;
    tools.choose(ChartTools::Tool::ParallelRule);
    tools.beginRule({0, 0}, 0.25 * core::kPi);
    tools.drag({500, -20});
    tools.release();
    tools.beginRule({50, 50}, 1.9);
    EXPECT_DOUBLE_EQ(tools.rule()->direction_rad, 0.25 * core::kPi) << "laid down again";
    tools.drag({50, 150}, true);
    EXPECT_DOUBLE_EQ(tools.rule()->direction_rad, 0.5 * core::kPi) << "turned about its place";
}

TEST(ChartTools, TheDistanceOfARuleIsSquareToIt) {
    const ChartTools::Rule rule{{1000.0, 300.0}, 0.0};
    EXPECT_NEAR(ChartTools::offset_m(rule, {-500.0, 0.0}), 300.0, 1e-9);
    EXPECT_NEAR(ChartTools::offset_m(rule, {0.0, 485.2}), -185.2, 1e-9);
    const core::LocalFrame& frame = galle()->area->frame;
    EXPECT_EQ(of(ruleText(rule, frame, NorthEast{0.0, 485.2})),
              "000°T, 0.10 M 1.0 cables to port of the own ship");
    EXPECT_EQ(of(ruleText(rule, frame, {})), "000°T");
}

/// Relative luminance and contrast after WCAG 2.1.
double luminance(const QColor& colour) {
    const auto linear = [](double c) {
        return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(static_cast<double>(colour.redF())) +
           0.7152 * linear(static_cast<double>(colour.greenF())) +
           0.0722 * linear(static_cast<double>(colour.blueF()));
}
double contrast(const QColor& a, const QColor& b) {
    const double high = std::max(luminance(a), luminance(b)), low = std::min(luminance(a), luminance(b));
    return (high + 0.05) / (low + 0.05);
}

class Palettes : public ::testing::TestWithParam<PaletteName> {};

TEST_P(Palettes, WordsStandOutFromWhatIsBehindThem) {
    const ChartPalette& p = chartPalette(GetParam());
    for (const QColor& behind : {p.shallow, p.unsafe, p.safe, p.deep, p.land, p.noDepths}) {
        EXPECT_GE(contrast(p.ink, behind), 4.5) << behind.name().toStdString();
        EXPECT_GE(contrast(p.quiet, behind), 4.5) << behind.name().toStdString();
    }
    for (const QColor& behind : {p.shallow, p.unsafe}) EXPECT_GE(contrast(p.shoalSounding, behind), 4.5);
    for (const QColor& behind : {p.safe, p.deep}) {
        EXPECT_GE(contrast(p.sounding, behind), 4.5);
        for (const QColor& word :
             {p.target, p.hostile, p.route, p.zone, p.limit, p.place, p.tool, p.prediction})
            EXPECT_GE(contrast(word, behind), 4.0) << word.name().toStdString();
    }
    EXPECT_GE(contrast(p.panelInk, p.panel), 4.5);
    EXPECT_GE(contrast(p.panelQuiet, p.panel), 4.5);
}

TEST_P(Palettes, DepthsAreAStairInOneDirection) {
    const ChartPalette& p = chartPalette(GetParam());
    const bool day = GetParam() == PaletteName::Day;
    const std::array<QColor, 4> stair{p.shallow, p.unsafe, p.safe, p.deep};
    for (std::size_t i = 1; i < stair.size(); ++i)
        EXPECT_EQ(luminance(stair[i]) > luminance(stair[i - 1]), day) << i;
}

TEST(Palettes, NightIsDark) {
    const ChartPalette& p = chartPalette(PaletteName::Night);
    for (const QColor& area : {p.shallow, p.unsafe, p.safe, p.deep, p.land, p.noDepths, p.drying, p.panel})
        EXPECT_LT(luminance(area), 0.015);
}

INSTANTIATE_TEST_SUITE_P(All, Palettes,
                         ::testing::Values(PaletteName::Day, PaletteName::Dusk, PaletteName::Night));

}  // namespace
}  // namespace sagara::ui::test
