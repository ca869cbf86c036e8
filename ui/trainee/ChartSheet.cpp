#include "ui/trainee/ChartSheet.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <cmath>

#include "core/base/Units.h"
#include "ui/chart/Format.h"
#include "ui/widgets/AreaLayers.h"
#include "ui/widgets/ChartFurniture.h"
#include "ui/widgets/ChartTexts.h"
#include "ui/widgets/Measure.h"

namespace sagara::ui::console {
namespace {

constexpr double kPixel_mm = 0.2646;  ///< the chart's logical pixel on paper
constexpr double kMargin_mm = 14.0, kFoot_mm = 16.0;
constexpr double kLetter_px = 11.0;

/// Scales a chart of paper may have.
double niceDenominator(double least) {
    for (double decade = 1000.0;; decade *= 10.0)
        for (const double step : {1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.5})
            if (step * decade >= least) return step * decade;
}

/// True rose of 360 degrees.
void drawRose(QPainter& painter, QPointF at, double radius, double north_rad, const ChartPalette& colours) {
    painter.save();
    painter.translate(at);
    painter.rotate(north_rad / core::kDegree_rad);
    painter.setPen(QPen(colours.tool, 0.8));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(QPointF(), radius, radius);
    QFont letters = painter.font();
    letters.setPixelSize(9);
    painter.setFont(letters);
    for (int deg = 0; deg < 360; ++deg) {
        painter.save();
        painter.rotate(deg);
        const double tick = deg % 30 == 0 ? 0.14 : deg % 10 == 0 ? 0.1 : deg % 5 == 0 ? 0.07 : 0.045;
        painter.drawLine(QPointF(0.0, -radius), QPointF(0.0, -radius * (1.0 - tick)));
        if (deg % 30 == 0)
            painter.drawText(QRectF(-16.0, -radius - 13.0, 32.0, 12.0), Qt::AlignCenter,
                             QStringLiteral("%1").arg(deg, 3, 10, QLatin1Char('0')));
        if (deg % 90 == 0) painter.drawLine(QPointF(0.0, -0.1 * radius), QPointF(0.0, -0.82 * radius));
        painter.restore();
    }
    painter.setBrush(colours.tool);
    painter.drawPolygon(QPolygonF{QPointF(0.0, -0.84 * radius), QPointF(-0.05 * radius, -0.7 * radius),
                                  QPointF(0.05 * radius, -0.7 * radius)});
    painter.restore();
}

/// Of the corners of the sheet that with the most water about the rose.
QPointF placeOfRose(const PreparedChart& chart, const ChartTransform& view, double radius) {
    const QSizeF size = view.size();
    const double off = radius + 40.0;
    QPointF best(size.width() - off, size.height() - off);
    int most = -1;
    for (const QPointF at : {best, QPointF(off, size.height() - off - 60.0), QPointF(size.width() - off, off),
                             QPointF(off, off)}) {
        int water = 0;
        for (int i = -3; i <= 3; ++i)
            for (int k = -3; k <= 3; ++k) {
                const core::NorthEast p = view.toChart(at + radius / 3.0 * QPointF(i, k));
                if (!chart.area->isLand(p)) ++water;
            }
        if (water > most) {
            most = water;
            best = at;
        }
    }
    return best;
}

void drawFoot(QPainter& painter, const QRectF& foot, const PreparedChart& chart, double denominator,
              const ChartPalette& colours) {
    const core::Area& area = *chart.area;
    QFont letters = painter.font();
    letters.setPixelSize(15);
    letters.setBold(true);
    painter.setFont(letters);
    painter.setPen(colours.ink);
    painter.drawText(
        foot, Qt::AlignLeft | Qt::AlignTop,
        QStringLiteral("%1   %2").arg(QString::fromStdString(area.name), chart::naturalScale(denominator)));
    painter.drawText(foot, Qt::AlignRight | Qt::AlignTop,
                     QCoreApplication::translate("sagara::ui::console", "NOT FOR NAVIGATION"));
    letters.setPixelSize(10);
    letters.setBold(false);
    painter.setFont(letters);
    painter.drawText(foot.adjusted(0.0, 20.0, 0.0, 0.0),
                     static_cast<int>(Qt::AlignLeft | Qt::AlignTop) | Qt::TextWordWrap,
                     depthNote(area) + QLatin1Char(' ') + QString::fromStdString(area.notice));
}

}  // namespace

QString writeChartSheet(const PreparedChart& chart, chart::Extent about, const QString& path) {
    if (about.empty) about = chart.extent;
    const core::NorthEast margin{0.1 * about.height_m() + 400.0, 0.1 * about.width_m() + 400.0};
    about.include(about.southWest - margin);
    about.include(about.northEast + margin);

    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return file.errorString();
    QPdfWriter pdf(&file);
    pdf.setTitle(QString::fromStdString(chart.area->name));
    pdf.setResolution(300);
    const bool wide = about.width_m() > about.height_m();
    pdf.setPageLayout(QPageLayout(QPageSize(QPageSize::A3),
                                  wide ? QPageLayout::Landscape : QPageLayout::Portrait, QMarginsF()));
    const QSizeF page_mm = pdf.pageLayout().fullRect(QPageLayout::Millimeter).size();
    const QRectF frame_mm(kMargin_mm, kMargin_mm, page_mm.width() - 2.0 * kMargin_mm,
                          page_mm.height() - 2.0 * kMargin_mm - kFoot_mm);
    const double least =
        1000.0 * std::max(about.width_m() / frame_mm.width(), about.height_m() / frame_mm.height());
    const double denominator = niceDenominator(least);
    const QSizeF size(frame_mm.width() / kPixel_mm, frame_mm.height() / kPixel_mm);
    const ChartTransform view(size, about.centre(), 0.001 * denominator * kPixel_mm);

    QPainter painter(&pdf);
    if (!painter.isActive())
        return QCoreApplication::translate("sagara::ui::console", "The file cannot be written.");
    painter.scale(pdf.resolution() / 25.4 * kPixel_mm, pdf.resolution() / 25.4 * kPixel_mm);
    painter.translate(frame_mm.topLeft() / kPixel_mm);
    painter.setRenderHint(QPainter::Antialiasing);
    const ChartPalette& colours = chartPalette(PaletteName::Day);
    painter.save();
    painter.setClipRect(QRectF(QPointF(), size));
    painter.fillRect(QRectF(QPointF(), size), colours.noDepths);
    ChartCanvas canvas(painter, view, colours, kAllChartLayers, kLetter_px, kPixel_mm);
    const double rose = std::min(110.0, 0.14 * std::min(size.width(), size.height()));
    const QPointF at = placeOfRose(chart, view, rose);
    canvas.blockAround(at, rose + 14.0);
    canvas.labels.block(scaleBox(canvas));
    drawArea(canvas, chart);
    drawRose(painter, at, rose, chart.area->frame.convergence_rad(view.toChart(at)), colours);
    drawScaleBox(canvas, chart.area->frame, false);
    drawGraticuleTexts(canvas, chart.area->frame);
    painter.restore();
    painter.setPen(QPen(colours.ink, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(QPointF(), size));
    drawFoot(painter, QRectF(0.0, size.height() + 8.0, size.width(), kFoot_mm / kPixel_mm - 8.0), chart,
             denominator, colours);
    painter.end();
    return file.commit() ? QString() : file.errorString();
}

}  // namespace sagara::ui::console
