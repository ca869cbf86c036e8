#include "ui/widgets/PrintChart.h"

#include <QFile>
#include <QPageLayout>
#include <QPdfWriter>
#include <algorithm>
#include <cmath>

#include "ui/chart/Format.h"
#include "ui/widgets/AreaLayers.h"
#include "ui/widgets/AreaTexts.h"
#include "ui/widgets/ChartFurniture.h"
#include "ui/widgets/ChartTexts.h"
#include "ui/widgets/ChartWidget.h"
#include "ui/widgets/CompassRose.h"
#include "ui/widgets/SceneLayers.h"

namespace sagara::ui {
namespace {

constexpr double kUnit_mm = 25.4 / 96.0;  ///< layers draw in pixels of 96 to the inch
constexpr double kLetter = 9.0;
constexpr double kMargin = 10.0, kHead = 34.0, kFoot = 40.0;

Lettering inkLetters(double size, bool bold = false) {
    return {size, Qt::black, QColor(0, 0, 0, 0), bold, false};
}

void drawWords(QPainter& painter, const QRectF& page, const ChartSheet& sheet, double denominator) {
    const core::Area* const area = sheet.chart->area.get();
    const double top = page.top() + 0.5 * kHead;
    drawText(painter, {page.left(), top - 6.0}, Qt::AlignVCenter, sheet.title, inkLetters(15.0, true));
    if (!sheet.subtitle.isEmpty())
        drawText(painter, {page.left(), top + 10.0}, Qt::AlignVCenter, sheet.subtitle, inkLetters(9.5));
    drawText(painter, {page.right(), top - 6.0}, Qt::AlignRight | Qt::AlignVCenter, tr("NOT FOR NAVIGATION"),
             inkLetters(13.0, true));
    drawText(painter, {page.right(), top + 10.0}, Qt::AlignRight | Qt::AlignVCenter,
             tr("%1 on this sheet, north up").arg(chart::naturalScale(denominator)), inkLetters(9.5));
    if (area == nullptr) return;
    QStringList lines{QString::fromStdString(area->notice) + u' ' + depthNote(*area)};
    QStringList credits;
    for (const std::string& credit : area->attribution) credits << QString::fromStdString(credit);
    lines << credits.join(QStringLiteral("; "));
    double y = page.bottom() - kFoot + 12.0;
    for (const QString& line : lines) {
        const Lettering letters = inkLetters(8.0);
        drawText(painter, {page.left(), y}, Qt::AlignVCenter, elided(line, letters, page.width()), letters);
        y += 11.0;
    }
}

/// The part of the frame in which a rose covers least of what matters: a corner away from the own ship.
QPointF placeOfRose(const ChartCanvas& canvas, const ChartScene& scene, double radius) {
    const QRectF inner = canvas.frame.adjusted(radius + 26.0, radius + 26.0, -radius - 26.0, -radius - 26.0);
    QPointF ship = inner.topLeft();
    if (!scene.ownShips.empty()) ship = canvas.view.toScreen(scene.ownShips.front().position);
    QPointF best = inner.bottomRight();
    double farthest = -1.0;
    for (const QPointF corner : {inner.bottomRight(), inner.bottomLeft(), inner.topRight()}) {
        const QPointF off = corner - ship;
        const double away = off.x() * off.x() + off.y() * off.y();
        if (away > farthest * 1.3) farthest = away, best = corner;
    }
    return best;
}

void drawMap(QPainter& painter, const QRectF& box, const ChartSheet& sheet, double& denominator) {
    const double width_m = std::max(sheet.extent.width_m(), 50.0),
                 height_m = std::max(sheet.extent.height_m(), 50.0);
    const double scale = std::max(width_m / box.width(), height_m / box.height());
    const core::NorthEast centre =
        sheet.extent.southWest + 0.5 * (sheet.extent.northEast - sheet.extent.southWest);
    const ChartTransform view(box.size(), centre, scale);
    painter.save();
    painter.translate(box.topLeft());
    painter.setClipRect(QRectF(QPointF(), box.size()));
    painter.fillRect(QRectF(QPointF(), box.size()), Qt::white);
    ChartCanvas canvas(painter, view, chartPalette(PaletteName::Day), sheet.shown, kLetter, kUnit_mm);
    const double figures = std::pow(10.0, std::floor(std::log10(canvas.denominator)) - 2.0);
    denominator = figures * std::round(canvas.denominator / figures);
    const double radius = std::min(110.0, 0.16 * std::min(box.width(), box.height()));
    const QPointF rose = placeOfRose(canvas, sheet.scene, radius);
    for (const QRectF& name : drawArea(canvas, *sheet.chart)) canvas.labels.block(name);
    canvas.labels.block(scaleBox(canvas));
    canvas.blockAround(rose, radius);
    const core::LocalFrame nowhere{{}};
    const core::LocalFrame& frame = sheet.chart->area ? sheet.chart->area->frame : nowhere;
    drawGraticuleTexts(canvas, frame);
    drawCompassRose(painter, rose, radius, frame.convergence_rad(centre) - view.up_rad(), canvas.palette.ink,
                    canvas.palette.halo);
    drawScene(canvas, sheet.scene, routeShape(sheet.scene.route, sheet.scene.path, routeStep_m(view)), frame);
    drawScaleBox(canvas, frame, false);
    painter.restore();
}

}  // namespace

ChartSheet sheetOf(const ChartWidget& chart, const QString& title, const QString& subtitle) {
    ChartSheet sheet;
    sheet.chart = chart.chart();
    sheet.scene = chart.scene();
    sheet.scene.handles.clear();
    sheet.shown = chart.layers();
    sheet.extent = chart.view().extent();
    sheet.title = title;
    sheet.subtitle = subtitle;
    return sheet;
}

void drawChartSheet(QPainter& painter, const QRectF& page, double dots_perMm, const ChartSheet& sheet) {
    const double dots = dots_perMm * kUnit_mm;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(page.topLeft());
    painter.scale(dots, dots);
    const QRectF all(0.0, 0.0, page.width() / dots, page.height() / dots);
    const QRectF box = all.adjusted(0.0, kHead + 4.0, 0.0, -kFoot);
    double denominator = 1.0;
    drawMap(painter, box.adjusted(kMargin, kMargin, -kMargin, -kMargin), sheet, denominator);
    painter.setBrush(Qt::NoBrush);
    for (const double edge : {0.0, kMargin}) {
        painter.setPen(QPen(Qt::black, edge == 0.0 ? 2.0 : 1.0));
        painter.drawRect(box.adjusted(edge, edge, -edge, -edge));
    }
    drawWords(painter, all, sheet, denominator);
    painter.restore();
}

bool printChartSheet(QPagedPaintDevice& device, const ChartSheet& sheet) {
    QPainter painter;
    if (!painter.begin(&device)) return false;
    const double dots_perMm = device.logicalDpiX() / 25.4;
    const QRectF page(QPointF(), device.pageLayout().paintRect(QPageLayout::Millimeter).size() * dots_perMm);
    drawChartSheet(painter, page, dots_perMm, sheet);
    return painter.end();
}

std::optional<QString> writeChartPdf(const QString& file, const ChartSheet& sheet) {
    QFile out(file);
    if (!out.open(QIODevice::WriteOnly)) return tr("%1 cannot be written: %2").arg(file, out.errorString());
    {
        QPdfWriter writer(&out);
        writer.setTitle(sheet.title);
        writer.setCreator(QStringLiteral("Sagara"));
        writer.setResolution(600);
        writer.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Landscape,
                                         QMarginsF(10.0, 10.0, 10.0, 10.0), QPageLayout::Millimeter));
        if (!printChartSheet(writer, sheet)) return tr("%1 cannot be written.").arg(file);
    }
    if (out.error() != QFileDevice::NoError || !out.flush())
        return tr("%1 cannot be written: %2").arg(file, out.errorString());
    return std::nullopt;
}

}  // namespace sagara::ui
