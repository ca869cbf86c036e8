#pragma once

#include <QPainter>
#include <QString>
#include <memory>
#include <optional>

#include "ui/chart/Extent.h"
#include "ui/widgets/ChartScene.h"
#include "ui/widgets/PreparedChart.h"

class QPagedPaintDevice;
class QWidget;

/// A chart on paper: by day's colours, with graticule, compass rose, scale, title and "not for navigation".
namespace sagara::ui {

class ChartWidget;

struct ChartSheet {
    std::shared_ptr<const PreparedChart> chart;
    ChartScene scene;
    ChartLayers shown = kAllChartLayers;
    chart::Extent extent;  ///< north is up; all of it is on the sheet
    QString title;         ///< "Basic Navigation"
    QString subtitle;      ///< "Galle, Sri Lanka. 00:12:40 of the exercise"; may be empty
};

/// What a chart shows now, as a sheet.
ChartSheet sheetOf(const ChartWidget& chart, const QString& title, const QString& subtitle);

/// One sheet, all of the painter's page. `page`: its box in the painter's units, of which `dots_perMm` are a
/// millimetre.
void drawChartSheet(QPainter& painter, const QRectF& page, double dots_perMm, const ChartSheet& sheet);
/// On a printer or a PDF writer; false when it cannot be begun.
bool printChartSheet(QPagedPaintDevice& device, const ChartSheet& sheet);
/// A4 lying. The error is for the person who asked.
std::optional<QString> writeChartPdf(const QString& file, const ChartSheet& sheet);
/// Asks where to: a PDF file or a printer, paper and how it lies; then prints. Says what went wrong itself.
void askAndPrint(QWidget* parent, const ChartSheet& sheet);

}  // namespace sagara::ui
