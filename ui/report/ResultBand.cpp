#include "ui/report/ResultBand.h"

#include <algorithm>

#include "ui/report/Format.h"
#include "ui/report/Text.h"

namespace sagara::report {
namespace {

constexpr double kVerdict_mm = 58.0;     ///< width of the coloured field
constexpr double kScoreFrom_mm = 118.0;  ///< where the score begins
constexpr double kLeastHeight_mm = 32.0;
const TextStyle kVerdictStyle{20.0, colour::kPaper, true};
const TextStyle kWhoseStyle{10.0, colour::kPaper};
const TextStyle kWhyStyle{10.0, colour::kInk, true};
const TextStyle kFactStyle{9.0, colour::kQuiet};
const TextStyle kScoreStyle{30.0, colour::kInk, true};
const TextStyle kOfStyle{11.0, colour::kQuiet};
const TextStyle kMarkStyle{8.5, colour::kInk};
const TextStyle kAdvisoryStyle{9.0, colour::kInk, true};

QString countedTasks(const RunReport& report) {
    const auto done =
        std::count_if(report.tasks.begin(), report.tasks.end(), [](const TaskLine& t) { return t.done; });
    if (report.tasks.empty()) return tr("This lesson has no tasks.");
    return tr("%1 of %2 tasks done.").arg(done).arg(report.tasks.size());
}

QString countedDeductions(const RunReport& report) {
    double points = 0.0;
    for (const DeductionLine& line : report.deductions) points += line.points;
    if (report.deductions.empty()) return tr("No points were deducted.");
    if (report.deductions.size() == 1) return tr("1 deduction, %1 points.").arg(shortNumber(points, 1));
    return tr("%1 deductions, %2 points in all.").arg(report.deductions.size()).arg(shortNumber(points, 1));
}

/// The assessor's result goes before the automatic one, and says that it is hers.
void drawVerdict(QPainter& painter, const QRectF& area, const RunReport& report) {
    const bool overruled = report.assessor && report.assessor->overrule;
    const bool passed = overruled ? report.assessor->overrule->passed : report.passed;
    const QRectF field(area.topLeft(), QSizeF(kVerdict_mm, area.height()));
    painter.fillRect(field, passed ? colour::kPassed : colour::kFailed);
    drawText(painter, field.center() - QPointF(0.0, overruled ? 2.5 : 0.0),
             Qt::AlignHCenter | Qt::AlignVCenter, passed ? tr("PASSED") : tr("NOT PASSED"), kVerdictStyle);
    if (!overruled) return;
    const QString whose = tr("assessor: %1 of 100").arg(shortNumber(report.assessor->overrule->score, 1));
    drawText(painter, field.center() + QPointF(0.0, 6.0), Qt::AlignHCenter | Qt::AlignVCenter, whose,
             kWhoseStyle);
}

/// A scale from 0 to 100, filled up to the score, with a notch at the pass mark.
void drawScale(QPainter& painter, const QRectF& bar, double score, double passScore) {
    const auto x = [&](double points) {
        return bar.left() + bar.width() * std::clamp(points, 0.0, 100.0) / 100.0;
    };
    painter.fillRect(bar, colour::kRule);
    painter.fillRect(QRectF(bar.topLeft(), QPointF(x(score), bar.bottom())), colour::kNavy);
    painter.setPen(linePen(colour::kInk, 0.4));
    painter.drawLine(QPointF(x(passScore), bar.top() - 1.2), QPointF(x(passScore), bar.bottom() + 1.2));
}

void drawScore(QPainter& painter, const QRectF& area, const RunReport& report) {
    const QString score = shortNumber(report.score, 1);
    const double baseline_mm = area.top() + 13.0;
    drawText(painter, {area.left(), baseline_mm}, Qt::AlignLeft, score, kScoreStyle);
    const double after_mm = area.left() + width_mm(score, kScoreStyle) + 2.0;
    drawText(painter, {after_mm, baseline_mm}, Qt::AlignLeft, tr("of 100"), kOfStyle);
    drawScale(painter, {area.left(), area.top() + 16.8, area.width(), 1.8}, report.score, report.passScore);
    drawText(painter, {area.left(), area.top() + 24.0}, Qt::AlignLeft,
             tr("pass mark %1").arg(shortNumber(report.passScore, 1)), kMarkStyle);
    drawText(painter, {area.left(), area.top() + 29.0}, Qt::AlignLeft, tr("automatic score, advisory"),
             kAdvisoryStyle);
}

}  // namespace

Block resultBand(const RunReport& report) {
    const double width_mm = kScoreFrom_mm - kVerdict_mm - 10.0;
    const TextBlock why(fromStd(report.whyNot), kWhyStyle, width_mm, 8);
    const TextBlock facts(countedTasks(report) + QLatin1Char('\n') + countedDeductions(report), kFactStyle,
                          width_mm);
    const double why_mm = report.whyNot.empty() ? 0.0 : why.height_mm() + 1.5;
    Block block;
    block.before_mm = 4.5;
    block.height_mm = std::max(kLeastHeight_mm, why_mm + facts.height_mm() + 7.0);
    block.draw = [why, facts, why_mm, &report](QPainter& painter, const QRectF& area) {
        painter.fillRect(area, colour::kPanel);
        drawVerdict(painter, area, report);
        const QPointF words(area.left() + kVerdict_mm + 5.0,
                            area.center().y() - 0.5 * (why_mm + facts.height_mm()));
        if (why_mm > 0.0) why.draw(painter, words);
        facts.draw(painter, words + QPointF(0.0, why_mm));
        drawScore(painter, area.adjusted(kScoreFrom_mm, 0.5 * (area.height() - kLeastHeight_mm), -5.0, 0.0),
                  report);
    };
    return block;
}

}  // namespace sagara::report
