#include "ui/report/SignOff.h"

#include "ui/report/Text.h"

namespace sagara::report {
namespace {

constexpr double kLeastHeight_mm = 50.0;
constexpr double kBelowComment_mm = 27.0;  ///< decision and signatures
const TextStyle kTitleStyle{8.5, colour::kQuiet, true};
const TextStyle kChoiceStyle{9.0};
const TextStyle kCaptionStyle{7.5, colour::kQuiet};

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

void drawSignature(QPainter& painter, double from_mm, double to_mm, double y_mm, const QString& caption) {
    painter.setPen(linePen(colour::kInk, 0.2));
    painter.drawLine(QPointF(from_mm, y_mm), QPointF(to_mm, y_mm));
    drawText(painter, {from_mm, y_mm + 3.4}, Qt::AlignLeft, caption, kCaptionStyle);
}

void drawSignOff(QPainter& painter, const QRectF& area) {
    drawComment(painter, area.adjusted(0.0, 0.0, 0.0, -kBelowComment_mm));
    drawDecision(painter, {area.left(), area.bottom() - kBelowComment_mm + 6.0});
    const double y_mm = area.bottom() - 4.5;
    drawSignature(painter, area.left(), area.left() + 74.0, y_mm, tr("Assessor: name and signature"));
    drawSignature(painter, area.left() + 80.0, area.left() + 140.0, y_mm, tr("Trainee: signature"));
    drawSignature(painter, area.left() + 146.0, area.right(), y_mm, tr("Date"));
}

}  // namespace

Block signOff() {
    Block block;
    block.before_mm = 5.5;
    block.height_mm = kLeastHeight_mm;
    block.growsTo_mm = 110.0;
    block.draw = drawSignOff;
    return block;
}

}  // namespace sagara::report
