#include "ui/report/ChartLegend.h"

#include <algorithm>

#include "ui/report/LegendEntries.h"
#include "ui/report/Text.h"

namespace sagara::report {
namespace {

constexpr double kSign_mm = 9.0;  ///< room for the sign
constexpr double kRow_mm = 4.2;
constexpr std::size_t kColumns = 3;
const TextStyle kStyle{7.0};
const TextStyle kNoticeStyle{7.0, colour::kQuiet};

void drawEntry(QPainter& painter, const LegendEntry& entry, QPointF left, double width_mm) {
    painter.setBrush(Qt::NoBrush);
    entry.draw(painter, left + QPointF(0.5 * kSign_mm, 0.0));
    drawText(painter, left + QPointF(kSign_mm + 1.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter,
             elided(entry.meaning, kStyle, width_mm - kSign_mm - 2.0), kStyle);
}

QString notice(const RunReport& report, bool hasInset) {
    QStringList parts;
    if (!report.chartNotice.empty()) parts << fromStd(report.chartNotice);
    if (hasInset) parts << tr("Names and numbers inside the thin frame on the chart are in the inset.");
    return parts.join(QLatin1Char(' '));
}

}  // namespace

void drawChartLegend(QPainter& painter, const RunReport& report, const QRectF& area, double interval_s,
                     bool hasInset) {
    const std::vector<LegendEntry> entries = legendEntries(report, interval_s);
    const double column_mm = area.width() / static_cast<double>(kColumns);
    const std::size_t rows = (entries.size() + kColumns - 1) / kColumns;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const QPointF left(area.left() + column_mm * static_cast<double>(i / rows),
                           area.top() + kRow_mm * (static_cast<double>(i % rows) + 0.5));
        drawEntry(painter, entries[i], left, column_mm);
    }
    const TextBlock words(notice(report, hasInset), kNoticeStyle, area.width(), 2);
    words.draw(painter, {area.left(), area.top() + kRow_mm * static_cast<double>(rows) + 0.8});
}

}  // namespace sagara::report
