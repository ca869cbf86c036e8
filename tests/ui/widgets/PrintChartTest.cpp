#include "ui/widgets/PrintChart.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QImage>
#include <cstdlib>

#include "LessonScene.h"
#include "core/base/Units.h"
#include "ui/widgets/ChartWidget.h"
#include "ui/widgets/ForceArrows.h"

namespace sagara::ui {
namespace {

QImage sheetPicture(const ChartSheet& sheet, QSize size) {
    QImage image(size, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    drawChartSheet(painter, QRectF(QPointF(), QSizeF(size)), size.width() / 277.0, sheet);
    return image;
}

TEST(ForceArrows, ScaleKeepsStillUntilItDoesNotSuit) {
    const auto withForce = [](double force_N) {
        return std::vector<ShownForce>{{core::ForceCause::Hull, {}, {force_N, 0.0}}};
    };
    const double first = forceScale_NPerPx(withForce(90e3), 100.0, 0.0);
    EXPECT_LE(90e3 / first, 100.0);
    EXPECT_GE(90e3 / first, 40.0);
    EXPECT_EQ(forceScale_NPerPx(withForce(50e3), 100.0, first), first);
    EXPECT_GT(forceScale_NPerPx(withForce(300e3), 100.0, first), first);
    EXPECT_LT(forceScale_NPerPx(withForce(5e3), 100.0, first), first);
    EXPECT_GT(forceScale_NPerPx({}, 100.0, 0.0), 0.0);
}

TEST(ForceArrows, TheRudderPushesAtTheSternAndWhatDoesNotPushIsLeftOut) {
    core::ShipForces forces{};
    forces[static_cast<std::size_t>(core::ForceCause::Rudder)] = {.sway_N = -20e3, .yaw_Nm = 400e3};
    forces[static_cast<std::size_t>(core::ForceCause::Wind)] = {.sway_N = 10e3, .yaw_Nm = 50e3};
    forces[static_cast<std::size_t>(core::ForceCause::Waves)] = {.sway_N = 1.0};
    const auto shown = shownForces(forces, 50.0);
    ASSERT_EQ(shown.size(), 2u);
    EXPECT_NEAR(shown[0].at.x_m, -23.0, 1e-9);
    EXPECT_NEAR(shown[1].at.x_m, 5.0, 1e-9);
}

ChartSheet lessonSheet() {
    ChartSheet sheet;
    sheet.chart = test::galle();
    sheet.scene = test::sailedLesson({9.0}).front();
    sheet.extent = sheet.chart->extent;
    sheet.title = QStringLiteral("Basic Navigation");
    sheet.subtitle = QStringLiteral("Galle, 09:12:05 local, 12:05 of the exercise");
    return sheet;
}

TEST(PrintChart, ASheetIsFramedAndHasItsMap) {
    const QImage picture = sheetPicture(lessonSheet(), {1662, 1140});
    if (const char* folder = std::getenv("SAGARA_UI_PICTURES"))
        picture.save(QString::fromUtf8(folder) + QStringLiteral("/printed-chart.png"));
    int coloured = 0;
    for (int y = 0; y < picture.height(); y += 7)
        for (int x = 0; x < picture.width(); x += 7)
            coloured += QColor(picture.pixel(x, y)).saturation() > 20;
    EXPECT_GT(coloured, 5000);                                                   // water and land
    EXPECT_LT(QColor(picture.pixel(1, picture.height() / 2)).lightness(), 160);  // the frame
}

TEST(PrintChart, APdfIsWrittenOrTheReasonWhyNotIsTold) {
    const QString file = QDir::temp().filePath(QStringLiteral("sagara-chart-test.pdf"));
    ASSERT_FALSE(writeChartPdf(file, lessonSheet()));
    QFile written(file);
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    EXPECT_TRUE(written.read(5) == QByteArray("%PDF-"));
    EXPECT_GT(written.size(), 20'000);
    EXPECT_LT(written.size(), 20'000'000);
    written.remove();
    const auto trouble = writeChartPdf(QStringLiteral("/no/such/folder/chart.pdf"), lessonSheet());
    ASSERT_TRUE(trouble);
    EXPECT_TRUE(trouble->contains(QStringLiteral("/no/such/folder/chart.pdf")));
}

TEST(PrintChart, OfAWidgetIsWhatItShows) {
    ChartWidget chart;
    chart.resize(600, 400);
    chart.setChart(test::galle());
    chart.setHandles({{1, {}, {}}});
    const ChartSheet sheet = sheetOf(chart, QStringLiteral("T"), {});
    EXPECT_EQ(sheet.chart, test::galle());
    EXPECT_TRUE(sheet.scene.handles.empty());
    EXPECT_NEAR(sheet.extent.width_m(), chart.view().toMetres(chart.view().size().width()), 1.0);
}

}  // namespace
}  // namespace sagara::ui
