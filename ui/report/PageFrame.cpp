#include "ui/report/PageFrame.h"

#include "ui/report/Format.h"
#include "ui/report/Text.h"

namespace sagara::report {
namespace {

constexpr double kHeaderLine_mm = page::kTop_mm - 5.0;
constexpr double kFooterLine_mm = page::kBottom_mm + 3.0;
const TextStyle kNameStyle{12.0, colour::kNavy, true};
const TextStyle kWhatStyle{8.0, colour::kQuiet};
const TextStyle kTitleStyle{11.0, colour::kInk, true};
const TextStyle kFooterStyle{7.5, colour::kQuiet};
const TextStyle kAdvisoryStyle{7.5, colour::kInk, true};

void drawRule(QPainter& painter, double y_mm, double width_mm, const QColor& colour) {
    painter.setPen(linePen(colour, width_mm));
    painter.drawLine(QPointF(page::kLeft_mm, y_mm), QPointF(page::kRight_mm, y_mm));
}

QString whoAndWhen(const RunReport& report) {
    const QString trainee = report.trainee.empty() ? tr("trainee not named") : fromStd(report.trainee);
    return trainee + QStringLiteral(" · ") + localDate(report.start, report.utcOffset_min);
}

}  // namespace

void drawHeader(QPainter& painter, const QString& title) {
    const double baseline_mm = kHeaderLine_mm - 2.2;
    drawText(painter, {page::kLeft_mm, baseline_mm}, Qt::AlignLeft, tr("Sagara"), kNameStyle);
    const double after_mm = page::kLeft_mm + width_mm(tr("Sagara"), kNameStyle) + 2.5;
    drawText(painter, {after_mm, baseline_mm}, Qt::AlignLeft, tr("ship-handling simulator"), kWhatStyle);
    drawText(painter, {page::kRight_mm, baseline_mm}, Qt::AlignRight, title, kTitleStyle);
    drawRule(painter, kHeaderLine_mm, 0.5, colour::kNavy);
}

void drawFooter(QPainter& painter, const RunReport& report, std::size_t page, std::size_t pages) {
    drawRule(painter, kFooterLine_mm, 0.15, colour::kRule);
    const double first_mm = kFooterLine_mm + 3.6, second_mm = first_mm + 3.6;
    const double room_mm = page::kTextWidth_mm - 50.0;
    const QString lesson = elided(fromStd(report.scenarioName), kFooterStyle, room_mm);
    drawText(painter, {page::kLeft_mm, first_mm}, Qt::AlignLeft, lesson, kFooterStyle);
    drawText(painter, {page::kLeft_mm, second_mm}, Qt::AlignLeft,
             elided(whoAndWhen(report), kFooterStyle, room_mm), kFooterStyle);
    drawText(painter, {page::kRight_mm, first_mm}, Qt::AlignRight, tr("page %1 of %2").arg(page).arg(pages),
             kFooterStyle);
    drawText(painter, {page::kRight_mm, second_mm}, Qt::AlignRight, tr("automatic score, advisory"),
             kAdvisoryStyle);
}

}  // namespace sagara::report
