#include <algorithm>
#include <cmath>
#include <vector>

#include "ui/report/Chart.h"
#include "ui/report/ChartSigns.h"
#include "ui/report/Format.h"
#include "ui/report/Sound.h"

namespace sagara::report {
namespace {

constexpr double kSameSpot_mm = 2.5;
constexpr double kReach_mm = 40.0;
constexpr double kHeight_mm = 3.7;
const TextStyle kNumberStyle{7.0, colour::kFailed, true};

/// Deductions so close on the page that they share one symbol.
struct Spot {
    QPointF at;
    std::vector<int> numbers;
};

std::vector<Spot> spotsOf(const Chart& chart) {
    std::vector<Spot> spots;
    int number = 0;
    for (const DeductionLine& line : chart.report.deductions) {
        ++number;
        const QPointF at = chart.view.toPage(line.place);
        if (!isFinite(line.place) || !chart.details(at)) continue;
        const auto near = [&](const Spot& s) {
            return std::hypot(s.at.x() - at.x(), s.at.y() - at.y()) < kSameSpot_mm;
        };
        const auto found = std::find_if(spots.begin(), spots.end(), near);
        if (found != spots.end()) {
            found->numbers.push_back(number);
        } else {
            spots.push_back({at, {number}});
        }
    }
    return spots;
}

void drawSymbol(Chart& chart, const Spot& spot, const QRectF& box, const TextBlock& words) {
    chart.painter.setPen(linePen(colour::kFailed, 0.25));
    chart.painter.drawLine(spot.at, box.center());
    drawDeductionCapsule(chart.painter, box);
    words.draw(chart.painter, {box.left(), box.center().y() - 0.5 * words.height_mm()}, Qt::AlignHCenter);
}

}  // namespace

/// A cross at the place and the numbers in a capsule beside it.
void labelDeductions(Chart& chart) {
    const std::vector<Spot> spots = spotsOf(chart);
    for (const Spot& spot : spots) chart.labels.block(QRectF(spot.at.x() - 0.7, spot.at.y() - 0.7, 1.4, 1.4));
    for (const Spot& spot : spots) {
        const QString numbers = ranges(spot.numbers);
        const TextBlock measured(numbers, kNumberStyle, 24.0, 3);
        const double wide_mm = std::max(kHeight_mm, measured.widest_mm() + 2.2);
        const TextBlock words(numbers, kNumberStyle, wide_mm, 3);
        const QSizeF size(wide_mm, std::max(kHeight_mm, words.height_mm() + 0.5));
        std::optional<QRectF> box = chart.labels.place(spot.at, size, 1.6, kReach_mm);
        if (!box)
            box = QRectF(spot.at + QPointF(1.6, -0.5 * size.height()),
                         size);  // over others rather than not at all
        drawSymbol(chart, spot, *box, words);
    }
    for (const Spot& spot : spots) drawDeductionCross(chart.painter, spot.at);
}

}  // namespace sagara::report
