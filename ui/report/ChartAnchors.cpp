#include "ui/report/Chart.h"
#include "ui/report/ChartSigns.h"
#include "ui/report/Format.h"

namespace sagara::report {
namespace {

constexpr double kHalf_mm = 1.7;
const TextStyle kStyle{7.0, colour::kInk, true};

}  // namespace

void drawAnchors(Chart& chart) {
    for (const AnchorDrop& anchor : chart.report.anchors) {
        const QPointF at = chart.view.toPage(anchor.position);
        drawAnchorSign(chart.painter, at, kHalf_mm);
        chart.labels.block(QRectF(at.x() - kHalf_mm, at.y() - kHalf_mm, 2.0 * kHalf_mm, 2.0 * kHalf_mm));
    }
}

void labelAnchors(Chart& chart) {
    for (const AnchorDrop& anchor : chart.report.anchors) {
        if (!chart.details(anchor.position)) continue;
        const QString words = tr("let go %1").arg(clockTime(anchor.time_s));
        labelNear(chart, chart.view.toPage(anchor.position), kHalf_mm + 0.3, 16.0, words, kStyle);
    }
}

}  // namespace sagara::report
