#include "ui/chart/Format.h"

#include <gtest/gtest.h>

#include <limits>

#include "ui/chart/Graticule.h"
#include "ui/chart/ScaleBar.h"

namespace sagara::chart {
namespace {

std::string of(const QString& text) { return text.toStdString(); }
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(ChartFormat, NumbersHaveATrueMinusAndNoMinusZero) {
    EXPECT_EQ(of(number(-2.31, 1)), "−2.3");
    EXPECT_EQ(of(number(-0.04, 1)), "0.0");
    EXPECT_EQ(of(number(12.0, 0)), "12");
    EXPECT_EQ(of(number(kNan, 1)), "–");
    EXPECT_EQ(of(shortNumber(4.0, 2)), "4");
    EXPECT_EQ(of(shortNumber(2.25, 2)), "2.25");
    EXPECT_EQ(of(shortNumber(100.0, 1)), "100");
}

TEST(ChartFormat, BearingsHaveThreeFiguresOnOneTurn) {
    EXPECT_EQ(of(bearing(0.0)), "000");
    EXPECT_EQ(of(bearing(359.7)), "000");
    EXPECT_EQ(of(bearing(405.0)), "045");
    EXPECT_EQ(of(bearing(-90.0)), "270");
}

TEST(ChartFormat, PlacesAreDegreesAndDecimalMinutes) {
    EXPECT_EQ(of(latitude(6.0325, 2)), "006°01.95'N");
    EXPECT_EQ(of(longitude(80.2268, 1)), "080°13.6'E");
    EXPECT_EQ(of(latitude(-33.5, 1)), "033°30.0'S");
    EXPECT_EQ(of(longitude(-0.0001, 2)), "000°00.01'W");
    EXPECT_EQ(of(longitude(179.99999, 1)), "180°00.0'E") << "minutes never read 60";
}

TEST(ChartFormat, ScalesAreGroupedByThousands) {
    EXPECT_EQ(of(naturalScale(15000.0)), "1:15\u00a0000");
    EXPECT_EQ(of(naturalScale(999.6)), "1:1\u00a0000");
    EXPECT_EQ(of(naturalScale(kNan)), "–");
}

TEST(Graticule, StepsAreThoseOfCharts) {
    EXPECT_EQ(graticuleStep_min(1.0), 0.01);
    EXPECT_EQ(graticuleStep_min(1852.0), 1.0);
    EXPECT_EQ(graticuleStep_min(1853.0), 2.0);
    EXPECT_EQ(graticuleStep_min(1e9), 60.0);
}

TEST(Graticule, LinesLieAtTheirLatitudesAndLongitudes) {
    const core::LocalFrame frame({6.02, 80.228});
    Extent shown;
    shown.include({-3000.0, -3000.0});
    shown.include({3000.0, 3000.0});
    const auto across = parallels(frame, shown, 1.0), up = meridians(frame, shown, 1.0);
    EXPECT_EQ(across.size(), 3u);
    EXPECT_EQ(up.size(), 3u);
    for (const GridLine& line : across) EXPECT_NEAR(frame.toGeo(line.from).lat_deg, line.value_deg, 1e-9);
    for (const GridLine& line : up) EXPECT_NEAR(frame.toGeo(line.to).lon_deg, line.value_deg, 1e-9);
}

TEST(ScaleBar, TheLongestPartThatFitsElseTheShortest) {
    EXPECT_EQ(scaleBarPart_cables(185.2), 1.0);
    EXPECT_EQ(scaleBarPart_cables(185.1), 0.5);
    EXPECT_EQ(scaleBarPart_cables(1.0), 0.05);
}

}  // namespace
}  // namespace sagara::chart
