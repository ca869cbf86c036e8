#include "ui/widgets/ToolLayer.h"

#include <cmath>

#include "ui/widgets/ChartTexts.h"
#include "ui/widgets/ScreenLines.h"

namespace sagara::ui {
namespace {

void drawCross(ChartCanvas& canvas, QPointF at) {
    canvas.painter.drawLine(at - QPointF(6.0, 0.0), at + QPointF(6.0, 0.0));
    canvas.painter.drawLine(at - QPointF(0.0, 6.0), at + QPointF(0.0, 6.0));
}

/// Words on a small panel, moved into the frame.
void drawTag(ChartCanvas& canvas, QPointF at, const QString& words) {
    Lettering letters = canvas.letters(1.0, canvas.palette.panelInk);
    letters.halo = QColor(0, 0, 0, 0);
    letters.bold = true;
    const QSizeF size = textSize_px({words}, letters) + QSizeF(12.0, 6.0);
    QRectF box(at, size);
    const QRectF inner = canvas.frame.adjusted(4.0, 4.0, -4.0, -4.0);
    if (box.right() > inner.right()) box.moveRight(inner.right());
    if (box.bottom() > inner.bottom()) box.moveBottom(inner.bottom());
    if (box.left() < inner.left()) box.moveLeft(inner.left());
    if (box.top() < inner.top()) box.moveTop(inner.top());
    canvas.painter.setPen(chartPen(canvas.palette.tool, 1.0));
    canvas.painter.setBrush(canvas.palette.panel);
    canvas.painter.drawRoundedRect(box, 3.0, 3.0);
    drawText(canvas.painter, box.center(), Qt::AlignHCenter | Qt::AlignVCenter, words, letters);
}

void drawRange(ChartCanvas& canvas, const ChartTools::Range& range, const core::LocalFrame& frame) {
    const QPointF a = canvas.view.toScreen(range.from), b = canvas.view.toScreen(range.to);
    canvas.painter.setPen(chartPen(canvas.palette.halo, 4.5));
    canvas.painter.drawLine(a, b);
    canvas.painter.setPen(chartPen(canvas.palette.tool, 2.0));
    canvas.painter.drawLine(a, b);
    canvas.painter.setPen(chartPen(canvas.palette.tool, 1.2, Qt::DotLine));
    const double r = std::hypot(b.x() - a.x(), b.y() - a.y());
    canvas.painter.setBrush(Qt::NoBrush);
    if (r < 4000.0) canvas.painter.drawEllipse(a, r, r);
    canvas.painter.setPen(chartPen(canvas.palette.tool, 2.0));
    drawCross(canvas, a);
    drawCross(canvas, b);
    drawTag(canvas, b + QPointF(12.0, 12.0), rangeBearingText(measure(frame, range.from, range.to)));
}

void drawRule(ChartCanvas& canvas, const ChartTools::Rule& rule, const core::LocalFrame& frame,
              std::optional<core::NorthEast> ownShip) {
    const core::NorthEast along = core::unitVector(rule.direction_rad);
    const double reach_m = canvas.view.toMetres(canvas.frame.width() + canvas.frame.height()) +
                           core::distance(rule.through, canvas.view.centre());
    const std::array<core::NorthEast, 2> line{rule.through - reach_m * along, rule.through + reach_m * along};
    const QPointF a = canvas.view.toScreen(line[0]), b = canvas.view.toScreen(line[1]);
    canvas.painter.setPen(chartPen(canvas.palette.halo, 4.5));
    canvas.painter.drawLine(a, b);
    canvas.painter.setPen(chartPen(canvas.palette.tool, 2.0));
    canvas.painter.drawLine(a, b);
    const QPointF at = canvas.view.toScreen(rule.through);
    drawCross(canvas, at);
    if (ownShip) {
        const double off_m = ChartTools::offset_m(rule, *ownShip);
        const core::NorthEast foot = *ownShip + off_m * core::turnedRight(along);
        canvas.painter.setPen(dashedChartPen(canvas.palette.tool, 1.5, 4.0, 4.0));
        canvas.painter.drawLine(canvas.view.toScreen(*ownShip), canvas.view.toScreen(foot));
    }
    drawTag(canvas, at + QPointF(12.0, 12.0), ruleText(rule, frame, ownShip));
}

}  // namespace

QString ruleText(const ChartTools::Rule& rule, const core::LocalFrame& frame,
                 std::optional<core::NorthEast> ownShip) {
    const QString direction = bearingText(trueDirection_rad(frame, rule.through, rule.direction_rad));
    if (!ownShip) return direction;
    const double off_m = ChartTools::offset_m(rule, *ownShip);
    return (off_m < 0.0 ? tr("%1, %2 to port of the own ship") : tr("%1, %2 to starboard of the own ship"))
        .arg(direction, distanceText(std::abs(off_m)));
}

void drawTools(ChartCanvas& canvas, const ChartTools& tools, const core::LocalFrame& frame,
               std::optional<core::NorthEast> ownShip) {
    if (tools.rule()) drawRule(canvas, *tools.rule(), frame, ownShip);
    if (tools.range()) drawRange(canvas, *tools.range(), frame);
}

void drawHandles(ChartCanvas& canvas, const ChartScene& scene, std::optional<std::size_t> dragged,
                 core::NorthEast draggedFrom) {
    for (std::size_t i = 0; i < scene.handles.size(); ++i) {
        const QPointF at = canvas.view.toScreen(scene.handles[i].position);
        if (!canvas.holds(at)) continue;
        const bool now = dragged == i, open = scene.handles[i].open;
        const double half = (open ? 0.8 : 0.4) * canvas.letter_px;
        if (now) {
            canvas.painter.setPen(dashedChartPen(canvas.palette.tool, 1.5, 4.0, 4.0));
            canvas.painter.drawLine(canvas.view.toScreen(draggedFrom), at);
        }
        canvas.painter.setPen(chartPen(canvas.palette.tool, 1.8));
        canvas.painter.setBrush(open  ? QBrush(Qt::NoBrush)
                                : now ? canvas.palette.tool
                                      : canvas.palette.panel);
        canvas.painter.drawRect(QRectF(at.x() - half, at.y() - half, 2.0 * half, 2.0 * half));
    }
}

}  // namespace sagara::ui
