#include "ui/report/SignOff.h"

#include "ui/report/Blocks.h"
#include "ui/report/Format.h"

namespace sagara::report {
namespace {

constexpr double kLeastHeight_mm = 50.0;
constexpr double kBelowComment_mm = 27.0;  ///< decision and signatures
const TextStyle kTitleStyle{8.5, colour::kQuiet, true};
const TextStyle kChoiceStyle{9.0};
const TextStyle kCaptionStyle{7.5, colour::kQuiet};
const TextStyle kEnteredStyle{9.5};
const TextStyle kDecisionStyle{10.5, colour::kInk, true};
constexpr double kSignatures_mm = 18.0;
constexpr int kMostLines = 45;  ///< of one paragraph of a comment

void drawComment(QPainter& painter, const QRectF& box) {
    painter.setPen(linePen(colour::kQuiet, 0.25));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(box);
    drawText(painter, box.topLeft() + QPointF(2.0, 5.0), Qt::AlignLeft, tr("Assessor's comment"),
             kTitleStyle);
}

/// A box to tick and its text; gives the place of the next one.
double drawChoice(QPainter& painter, QPointF at, const QString& choice) {
    const double side_mm = 3.4;
    painter.setPen(linePen(colour::kInk, 0.25));
    painter.drawRect(QRectF(at.x(), at.y() - 0.5 * side_mm, side_mm, side_mm));
    drawText(painter, at + QPointF(side_mm + 1.6, 0.0), Qt::AlignLeft | Qt::AlignVCenter, choice,
             kChoiceStyle);
    return at.x() + side_mm + 1.6 + width_mm(choice, kChoiceStyle) + 8.0;
}

void drawDecision(QPainter& painter, QPointF at) {
    const QString title = tr("Assessor's decision");
    drawText(painter, at, Qt::AlignLeft | Qt::AlignVCenter, title, kTitleStyle);
    double x_mm = at.x() + width_mm(title, kTitleStyle) + 6.0;
    for (const QString& choice : {tr("competent"), tr("not yet competent"), tr("to be repeated")}) {
        x_mm = drawChoice(painter, {x_mm, at.y()}, choice);
    }
}

void drawSignature(QPainter& painter, double from_mm, double to_mm, double y_mm, const QString& caption,
                   const QString& entered = {}) {
    painter.setPen(linePen(colour::kInk, 0.2));
    painter.drawLine(QPointF(from_mm, y_mm), QPointF(to_mm, y_mm));
    drawText(painter, {from_mm, y_mm + 3.4}, Qt::AlignLeft, caption, kCaptionStyle);
    if (entered.isEmpty()) return;
    drawText(painter, {from_mm, y_mm - 1.2}, Qt::AlignLeft, elided(entered, kEnteredStyle, to_mm - from_mm),
             kEnteredStyle);
}

void drawSignatures(QPainter& painter, const QRectF& area, const AssessorNote& note) {
    const double y_mm = area.bottom() - 4.5;
    const bool entered = !note.signedBy.empty();
    drawSignature(painter, area.left(), area.left() + 74.0, y_mm,
                  entered ? tr("Assessor: signed off in Sagara") : tr("Assessor: name and signature"),
                  fromStd(note.signedBy));
    drawSignature(painter, area.left() + 80.0, area.left() + 134.0, y_mm, tr("Trainee: signature"));
    drawSignature(painter, area.left() + 140.0, area.right(), y_mm, tr("Date"),
                  entered ? utcTime(note.signedAt) : QString());
}

/// Nothing was entered: comment, decision and signatures by hand.
Block roomToWrite() {
    Block block;
    block.before_mm = 5.5;
    block.height_mm = kLeastHeight_mm;
    block.growsTo_mm = 110.0;
    block.draw = [](QPainter& painter, const QRectF& area) {
        drawComment(painter, area.adjusted(0.0, 0.0, 0.0, -kBelowComment_mm));
        drawDecision(painter, {area.left(), area.bottom() - kBelowComment_mm + 6.0});
        drawSignatures(painter, area, {});
    };
    return block;
}

/// A signed run without the assessor's own result confirms the automatic one; an unsigned one decides
/// nothing.
QString decisionText(const RunReport& report, const AssessorNote& note) {
    const auto result = [](bool passed) { return passed ? tr("passed") : tr("not passed"); };
    if (note.overrule) {
        return tr("%1, %2 of 100. This overrules the automatic result (%3, %4 of 100).")
            .arg(result(note.overrule->passed), shortNumber(note.overrule->score, 1), result(report.passed),
                 shortNumber(report.score, 1));
    }
    if (note.signedBy.empty()) return tr("The automatic result stands; not signed off.");
    return tr("%1, %2 of 100: as graded automatically.")
        .arg(result(report.passed), shortNumber(report.score, 1));
}

Block signatures(const AssessorNote& note) {
    Block block;
    block.before_mm = 4.0;
    block.height_mm = kSignatures_mm;
    block.growsTo_mm = kSignatures_mm;
    block.draw = [note](QPainter& painter, const QRectF& area) { drawSignatures(painter, area, note); };
    return block;
}

std::vector<Block> entered(const RunReport& report, const AssessorNote& note) {
    std::vector<Block> blocks{sectionTitle(tr("Assessor's result"))};
    blocks.push_back(paragraph(decisionText(report, note), kDecisionStyle, page::kTextWidth_mm, 1.0));
    if (note.overrule) {
        const QString reason = tr("Reason: %1").arg(fromStd(note.overrule->reason));
        blocks.push_back(paragraph(reason, kEnteredStyle, page::kTextWidth_mm, 1.0, 12));
    }
    if (!note.comment.empty()) {
        blocks.push_back(sectionTitle(tr("Assessor's comment")));
        for (const QString& part : fromStd(note.comment).split(QLatin1Char('\n'), Qt::SkipEmptyParts))
            blocks.push_back(paragraph(part, kEnteredStyle, page::kTextWidth_mm, 1.0, kMostLines));
    }
    blocks.back().keepWithNext = true;
    blocks.push_back(signatures(note));
    return blocks;
}

}  // namespace

std::vector<Block> signOff(const RunReport& report) {
    if (!report.assessor) return {roomToWrite()};
    return entered(report, *report.assessor);
}

}  // namespace sagara::report
