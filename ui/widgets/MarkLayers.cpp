#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/chart/Format.h"
#include "ui/chart/Marks.h"
#include "ui/widgets/AreaLayers.h"
#include "ui/widgets/AreaTexts.h"
#include "ui/widgets/SceneLayers.h"

namespace sagara::ui {
namespace {

/// Height of a symbol in pixels: smaller on a chart of small scale, where they would be all there is.
double mark_px(const ChartCanvas& canvas) {
    const double part = canvas.denominator <= 20000.0 ? 1.25 : canvas.denominator <= 40000.0 ? 1.05 : 0.8;
    return part * canvas.letter_px;
}
constexpr double kLightsTo = 30000.0, kNamesTo = 14000.0;  ///< denominators up to which they are written

/// A drop that begins at the mark and points to the lower right, as on paper charts.
void drawFlare(ChartCanvas& canvas, QPointF at, const QColor& colour) {
    const double long_px = 1.45 * canvas.letter_px, wide_px = 0.42 * canvas.letter_px;
    QPainterPath drop;
    drop.cubicTo(0.35 * long_px, -0.1 * wide_px, 0.7 * long_px, -wide_px, long_px, -0.55 * wide_px);
    drop.cubicTo(1.13 * long_px, -0.3 * wide_px, 1.13 * long_px, 0.3 * wide_px, long_px, 0.55 * wide_px);
    drop.cubicTo(0.7 * long_px, wide_px, 0.35 * long_px, 0.1 * wide_px, 0.0, 0.0);
    canvas.painter.save();
    canvas.painter.translate(at);
    canvas.painter.rotate(52.0);
    canvas.painter.setPen(Qt::NoPen);
    canvas.painter.setBrush(colour);
    canvas.painter.drawPath(drop);
    canvas.painter.restore();
}

QColor flareOf(const ChartPalette& palette, const core::Light& light) {
    switch (lightColour(light)) {
        case LightColour::Red:
            return palette.flareRed;
        case LightColour::Green:
            return palette.flareGreen;
        case LightColour::White:
            break;
    }
    return palette.flareWhite;
}

bool lateral(const core::Mark& mark) {
    return mark.kind == core::MarkKind::LateralPort || mark.kind == core::MarkKind::LateralStarboard;
}

/// Away from the nearest other mark, for a lateral mark the nearest of the other hand: the names of two buoys
/// that make a gate stay out of the channel.
bool wordsToTheRight(const ChartCanvas& canvas, const std::vector<core::Mark>& marks,
                     const core::Mark& mark) {
    const QPointF at = canvas.view.toScreen(mark.position);
    double nearest_px = 30.0 * canvas.letter_px;
    bool right = true;
    for (const core::Mark& other : marks) {
        if (&other == &mark || (lateral(mark) && (!lateral(other) || other.kind == mark.kind))) continue;
        const QPointF off = at - canvas.view.toScreen(other.position);
        const double distance_px = std::hypot(off.x(), off.y());
        if (distance_px >= nearest_px) continue;
        nearest_px = distance_px;
        right = off.x() >= 0.0;
    }
    return right;
}

/// Beside the symbol and clear of its flare; false when there is no room.
bool labelBeside(ChartCanvas& canvas, QPointF at, bool right, const QStringList& lines,
                 const Lettering& letters) {
    QRectF box(QPointF(), textSize_px(lines, letters));
    const double gap = 0.65 * mark_px(canvas) + 2.0;
    box.moveCenter(at);
    if (right) {
        box.moveLeft(at.x() + gap);
        box.moveBottom(std::min(box.bottom(), at.y() + 0.1 * canvas.letter_px));
    } else {
        box.moveRight(at.x() - gap);
    }
    if (!canvas.labels.isFree(box)) return false;
    canvas.labels.block(box);
    drawLines(canvas.painter, box, right ? Qt::AlignLeft : Qt::AlignRight, lines, letters);
    return true;
}

void draw(ChartCanvas& canvas, const core::Mark& mark, const chart::ChartMark& symbol) {
    const QPointF at = canvas.view.toScreen(mark.position);
    if (!canvas.holds(at)) return;
    const bool major = mark.kind == core::MarkKind::Lighthouse;
    if (mark.light && canvas.shows(ChartLayer::Lights) && (major || canvas.denominator <= kLightsTo)) {
        drawFlare(canvas, at, flareOf(canvas.palette, *mark.light));
        canvas.labels.block({at + QPointF(0.0, 0.15 * canvas.letter_px),
                             QSizeF(1.1 * canvas.letter_px, 1.15 * canvas.letter_px)});
    }
    chart::drawMark(canvas.painter, at, symbol, mark_px(canvas), canvas.palette.marks);
    canvas.blockAround(at, 0.55 * mark_px(canvas));
}

/// Names in italics where the mark is in no open source.
void label(ChartCanvas& canvas, const std::vector<core::Mark>& marks) {
    for (const core::Mark& mark : marks) {
        const QPointF at = canvas.view.toScreen(mark.position);
        if (!canvas.frame.contains(at)) continue;
        const bool light = mark.light && canvas.shows(ChartLayer::Lights);
        Lettering letters = canvas.letters(0.85, canvas.palette.ink);
        letters.italic = mark.fictional;
        const bool major = mark.kind == core::MarkKind::Lighthouse;
        QStringList lines;
        if (canvas.denominator <= (major ? 2.0 * kNamesTo : kNamesTo))
            lines << inTwoLines(plainName(mark.name), letters, 9.0 * canvas.letter_px);
        if (light && canvas.denominator <= (major ? 3.0 * kLightsTo : kLightsTo))
            lines << (canvas.denominator <= 2.0 * kNamesTo || major ? lightText(*mark.light)
                                                                    : lightCharacter(*mark.light));
        if (lines.isEmpty()) continue;
        const bool right = wordsToTheRight(canvas, marks, mark);
        if (!labelBeside(canvas, at, right, lines, letters) &&
            !labelBeside(canvas, at, !right, lines, letters))
            labelNear(canvas, at, 0.75 * mark_px(canvas), 2.2 * canvas.letter_px, lines, letters);
    }
}

}  // namespace

void drawMarks(ChartCanvas& canvas, const PreparedChart& chart) {
    for (std::size_t i = 0; i < chart.marks.size(); ++i) draw(canvas, chart.area->marks[i], chart.marks[i]);
}

void labelMarks(ChartCanvas& canvas, const PreparedChart& chart) { label(canvas, chart.area->marks); }

void drawSceneMarks(ChartCanvas& canvas, const ChartScene& scene) {
    for (const core::Mark& mark : scene.marks) draw(canvas, mark, chart::chartMarkOf(mark, scene.ialaRegion));
}

void labelSceneMarks(ChartCanvas& canvas, const ChartScene& scene) { label(canvas, scene.marks); }

}  // namespace sagara::ui
