#include "ui/widgets/ChartFurniture.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/Angle.h"
#include "ui/chart/Format.h"
#include "ui/chart/ScaleBar.h"
#include "ui/widgets/GraticuleStep.h"

namespace sagara::ui {
namespace {

constexpr int kParts = 4;
constexpr double kLongestBar = 13.0, kArrow = 2.6;  ///< of the letters

Lettering panelLetters(const ChartCanvas& canvas, double size, bool bold = false) {
    return {size * canvas.letter_px, canvas.palette.panelInk, QColor(0, 0, 0, 0), bold, false};
}

void drawPanel(ChartCanvas& canvas, const QRectF& box) {
    canvas.painter.setPen(chartPen(canvas.palette.panelBorder, 1.0));
    canvas.painter.setBrush(canvas.palette.panel);
    canvas.painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
}

struct Bar {
    double part_px;
    double part;  ///< in its unit
    bool miles;
};

Bar barFor(const ChartCanvas& canvas) {
    const double part_cables =
        chart::scaleBarPart_cables(canvas.view.toMetres(kLongestBar * canvas.letter_px) / kParts);
    const bool miles = part_cables * kParts >= 10.0;
    return {canvas.view.toPixels(part_cables * core::kCable_m), miles ? 0.1 * part_cables : part_cables,
            miles};
}

void drawBar(ChartCanvas& canvas, const Bar& bar, QPointF at) {
    const Lettering figures = panelLetters(canvas, 0.82);
    canvas.painter.setPen(chartPen(canvas.palette.panelInk, 1.0));
    for (int i = 0; i < kParts; ++i) {
        canvas.painter.setBrush(i % 2 == 0 ? QBrush(canvas.palette.panelInk) : QBrush(canvas.palette.panel));
        canvas.painter.drawRect(QRectF(at.x() + i * bar.part_px, at.y(), bar.part_px, 5.0));
    }
    for (const int i : {0, 2, 4}) {
        QString figure = chart::shortNumber(i * bar.part, 2);
        if (i == 4) figure += u' ' + (bar.miles ? tr("M") : i * bar.part <= 1.0 ? tr("cable") : tr("cables"));
        const double x = at.x() + i * bar.part_px;
        const double width = textWidth_px(chart::shortNumber(i * bar.part, 2), figures);
        drawText(canvas.painter, {i == 0 ? x : x - 0.5 * width, at.y() + 7.0}, Qt::AlignTop, figure, figures);
    }
}

void drawArrow(ChartCanvas& canvas, QPointF middle, double high_px, double north_rad) {
    const double h = 0.5 * high_px, down = 0.5 * canvas.letter_px;
    canvas.painter.save();
    canvas.painter.translate(middle);
    canvas.painter.rotate(north_rad / core::kDegree_rad);
    canvas.painter.setPen(chartPen(canvas.palette.panelInk, 1.2));
    canvas.painter.setBrush(canvas.palette.panelInk);
    canvas.painter.drawPolygon(
        QPolygonF{QPointF(0, -h + down), QPointF(-0.4 * h, h + down), QPointF(0, 0.65 * h + down)});
    canvas.painter.setBrush(canvas.palette.panel);
    canvas.painter.drawPolygon(
        QPolygonF{QPointF(0, -h + down), QPointF(0.4 * h, h + down), QPointF(0, 0.65 * h + down)});
    drawText(canvas.painter, {0.0, -h - 0.1 * canvas.letter_px}, Qt::AlignHCenter | Qt::AlignVCenter,
             QStringLiteral("N"), panelLetters(canvas, 1.0, true));
    canvas.painter.restore();
}

/// 13 786 is read as 13 800: the last figures say nothing about a screen.
double threeFigures(double value) {
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
    return unit * std::round(value / unit);
}

/// Where a line leaves the frame, first by its western or southern end.
std::optional<QPointF> edgePoint(QPointF from, QPointF to, const QRectF& frame) {
    double low = 0.0, high = 1.0;
    const QPointF d = to - from;
    const auto limit = [&](double start, double step, double least, double most) {
        if (std::abs(step) < 1e-9) return start >= least && start <= most;
        const double a = (least - start) / step, b = (most - start) / step;
        low = std::max(low, std::min(a, b));
        high = std::min(high, std::max(a, b));
        return low < high;
    };
    if (!limit(from.x(), d.x(), frame.left(), frame.right())) return {};
    if (!limit(from.y(), d.y(), frame.top(), frame.bottom())) return {};
    return from + low * d;
}

/// At one end of its line, or at the other when there is something already.
void drawEdgeText(ChartCanvas& canvas, const chart::GridLine& line, const QString& words,
                  const Lettering& letters) {
    const QRectF inner = canvas.frame.adjusted(3.0, 3.0, -3.0, -2.0);
    const QPointF from = canvas.view.toScreen(line.from), to = canvas.view.toScreen(line.to);
    for (const std::optional<QPointF>& at : {edgePoint(from, to, inner), edgePoint(to, from, inner)}) {
        if (!at) continue;
        QRectF box(QPointF(), textSize_px({words}, letters));
        box.moveCenter(*at);
        box.moveLeft(std::clamp(box.left(), inner.left(), inner.right() - box.width()));
        box.moveTop(std::clamp(box.top(), inner.top(), inner.bottom() - box.height()));
        if (!canvas.labels.isFree(box)) continue;
        canvas.labels.block(box);
        drawText(canvas.painter, box.center(), Qt::AlignHCenter | Qt::AlignVCenter, words, letters);
        return;
    }
}

void drawPair(ChartCanvas& canvas, const QRectF& box, const QString& upper, const QString& lower, bool bold) {
    const Lettering first = panelLetters(canvas, 1.0, bold);
    Lettering second = panelLetters(canvas, 0.88);
    second.colour = canvas.palette.panelQuiet;
    const double y = box.top() + 0.28 * box.height(), y2 = box.top() + 0.74 * box.height();
    drawText(canvas.painter, {box.left(), y}, Qt::AlignVCenter, elided(upper, first, box.width()), first);
    drawText(canvas.painter, {box.left(), y2}, Qt::AlignVCenter, elided(lower, second, box.width()), second);
}

}  // namespace

double readoutHeight_px(double letter_px) { return std::ceil(3.1 * letter_px); }

void drawReadout(ChartCanvas& canvas, const QRectF& strip, const ChartReadout& words) {
    QColor solid = canvas.palette.panel;
    solid.setAlpha(255);
    canvas.painter.fillRect(strip, solid);
    canvas.painter.setPen(chartPen(canvas.palette.panelBorder, 1.0));
    canvas.painter.drawLine(strip.topLeft() + QPointF(0.0, 0.5), strip.topRight() + QPointF(0.0, 0.5));
    const double gap = canvas.letter_px;
    const Lettering letters = panelLetters(canvas, 1.0, true);
    const double first = textWidth_px(QStringLiteral("000°00.00'N 000°00.00'W"), letters) + gap;
    const double second = textWidth_px(QStringLiteral("000°T 00.00 M 000.0 cables"), letters) + 3.0 * gap;
    QRectF box = strip.adjusted(gap, 0.0, -gap, 0.0);
    drawPair(canvas, {box.left(), box.top(), first, box.height()}, words.position, words.depth, true);
    const double third = box.left() + first + second + 2.0 * gap;
    const bool room = box.right() - third > 14.0 * canvas.letter_px;
    const double middleRight = room ? third - gap : box.right();
    drawPair(canvas,
             {box.left() + first + gap, box.top(), middleRight - box.left() - first - gap, box.height()},
             words.measured, words.measuredFrom, true);
    if (room)
        drawPair(canvas, {third, box.top(), box.right() - third, box.height()}, words.notice, words.source,
                 true);
}

QRectF scaleBox(const ChartCanvas& canvas) {
    const double u = canvas.letter_px;
    return {8.0, 8.0, (kArrow + kLongestBar + 3.8) * u, 4.3 * u};
}

void drawScaleBox(ChartCanvas& canvas, const core::LocalFrame& frame, bool headUp) {
    const double u = canvas.letter_px;
    const Bar bar = barFor(canvas);
    const QRectF box = scaleBox(canvas);
    drawPanel(canvas, box);
    const double north_rad = frame.convergence_rad(canvas.view.centre()) - canvas.view.up_rad();
    drawArrow(canvas, {box.left() + 0.55 * kArrow * u, box.center().y()}, 2.2 * u, north_rad);
    const QPointF at(box.left() + kArrow * u, box.top() + 0.95 * u);
    drawText(canvas.painter, at, Qt::AlignVCenter, chart::naturalScale(threeFigures(canvas.denominator)),
             panelLetters(canvas, 1.0, true));
    const QString up =
        headUp ? tr("head up %1").arg(chart::bearing(-north_rad / core::kDegree_rad) + QStringLiteral("°T"))
               : tr("north up");
    drawText(canvas.painter, {box.right() - 0.8 * u, at.y()}, Qt::AlignRight | Qt::AlignVCenter, up,
             panelLetters(canvas, 0.88));
    drawBar(canvas, bar, {at.x(), box.top() + 2.0 * u});
}

void drawGraticuleTexts(ChartCanvas& canvas, const core::LocalFrame& frame) {
    const Lettering letters = canvas.letters(0.82, canvas.palette.ink);
    const double step_min = graticuleStep_min(canvas.view, canvas.letter_px);
    const int decimals = step_min < 0.0999 ? 2 : 1;
    const chart::Extent shown = canvas.view.extent();
    for (const chart::GridLine& line : chart::parallels(frame, shown, step_min))
        drawEdgeText(canvas, line, chart::latitude(line.value_deg, decimals), letters);
    for (const chart::GridLine& line : chart::meridians(frame, shown, step_min))
        drawEdgeText(canvas, line, chart::longitude(line.value_deg, decimals), letters);
}

void drawEmptyNote(ChartCanvas& canvas, const QStringList& lines) {
    const Lettering letters = panelLetters(canvas, 1.15);
    const QSizeF size = textSize_px(lines, letters);
    QRectF box(QPointF(), size);
    box.moveCenter(canvas.frame.center());
    drawPanel(canvas, box.adjusted(-20.0, -14.0, 20.0, 14.0));
    drawLines(canvas.painter, box, Qt::AlignHCenter, lines, letters);
}

}  // namespace sagara::ui
