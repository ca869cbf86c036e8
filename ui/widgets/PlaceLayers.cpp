#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/base/Units.h"
#include "ui/chart/AnchorSign.h"
#include "ui/widgets/AreaLayers.h"
#include "ui/widgets/AreaTexts.h"

namespace sagara::ui {
namespace {

constexpr double kBerthsTo = 12000.0;  ///< denominator up to which berths are named

/// Denominators up to which a kind of place is named; facts that are drawn otherwise are never.
double namedTo(std::string_view kind) {
    struct Row {
        std::string_view kind;
        double denominator;
    };
    static constexpr std::array<Row, 15> kRows{{{"anchorage", 90000},
                                                {"bay", 60000},
                                                {"fort", 60000},
                                                {"headland", 30000},
                                                {"hill", 30000},
                                                {"beach", 20000},
                                                {"landmark", 14000},
                                                {"land", 14000},
                                                {"harbour_basin", 9000},
                                                {"jetty", 6000},
                                                {"entrance", 0},
                                                {"berth", 0},
                                                {"breakwater_head", 0},
                                                {"lighthouse", 0},
                                                {"port_reference", 0}}};
    const auto found =
        std::find_if(kRows.begin(), kRows.end(), [&](const Row& row) { return row.kind == kind; });
    return found == kRows.end() ? 20000.0 : found->denominator;
}

void drawAnchorage(ChartCanvas& canvas, QPointF at) {
    canvas.painter.setPen(chartPen(canvas.palette.place, 1.4));
    chart::strokeAnchor(canvas.painter, at, 0.6 * canvas.letter_px);
    canvas.blockAround(at, 0.65 * canvas.letter_px);
}

void labelPlace(ChartCanvas& canvas, const core::Place& place) {
    const QPointF at = canvas.view.toScreen(place.position);
    if (!canvas.frame.contains(at) || canvas.denominator > namedTo(place.kind)) return;
    const bool anchorage = place.kind == "anchorage", area = place.kind == "bay" || place.kind == "fort";
    Lettering letters =
        canvas.letters(area ? 1.0 : 0.85, anchorage ? canvas.palette.place : canvas.palette.quiet);
    letters.italic = place.kind == "bay" || anchorage;
    const QStringList lines = inTwoLines(plainName(place.name), letters, 8.0 * canvas.letter_px);
    if (anchorage) drawAnchorage(canvas, at);
    if (anchorage || area) {
        labelNear(canvas, at, anchorage ? 0.8 * canvas.letter_px : 0.0, 1.6 * canvas.letter_px, lines,
                  letters);
        return;
    }
    const bool named = labelNear(canvas, at, 0.4 * canvas.letter_px, 1.4 * canvas.letter_px, lines, letters);
    if (!named) return;
    canvas.painter.setPen(Qt::NoPen);
    canvas.painter.setBrush(letters.colour);
    canvas.painter.drawEllipse(at, 1.6, 1.6);
}

}  // namespace

void labelPlaces(ChartCanvas& canvas, const PreparedChart& chart) {
    for (const core::Place& place : chart.area->places) labelPlace(canvas, place);
}

void drawBerths(ChartCanvas& canvas, const PreparedChart& chart) {
    for (const core::Berth& berth : chart.area->berths) {
        canvas.painter.setPen(chartPen(canvas.palette.berth, 3.0));
        canvas.painter.drawLine(canvas.view.toScreen(berth.face.a), canvas.view.toScreen(berth.face.b));
        if (canvas.view.toPixels(20.0) < 14.0) continue;
        canvas.painter.setPen(Qt::NoPen);
        canvas.painter.setBrush(canvas.palette.quay);
        for (const core::Berth::Bollard& bollard : berth.bollards)
            canvas.painter.drawEllipse(canvas.view.toScreen(bollard.position), 2.0, 2.0);
    }
}

/// Along the face, on the land side of it, when the face is long enough for the words.
void labelBerths(ChartCanvas& canvas, const PreparedChart& chart) {
    if (canvas.denominator > kBerthsTo) return;
    const Lettering letters = canvas.letters(0.85, canvas.palette.berth);
    for (const core::Berth& berth : chart.area->berths) {
        const QString name = plainName(berth.name);
        const QPointF a = canvas.view.toScreen(berth.face.a), b = canvas.view.toScreen(berth.face.b);
        const double length_px = std::hypot(b.x() - a.x(), b.y() - a.y());
        if (length_px < textWidth_px(name, letters) + 4.0) continue;
        const core::NorthEast inland = -canvas.view.toMetres(0.85 * canvas.letter_px) * berth.outward();
        const QPointF at = canvas.view.toScreen(0.5 * (berth.face.a + berth.face.b) + inland);
        if (!canvas.frame.contains(at)) continue;
        double turned_deg = std::atan2(b.y() - a.y(), b.x() - a.x()) / core::kDegree_rad;
        if (std::abs(turned_deg) > 90.0) turned_deg += 180.0;
        const QRectF box(QPointF(), textSize_px({name}, letters));
        const QTransform turn = QTransform().translate(at.x(), at.y()).rotate(turned_deg);
        const QRectF turned = turn.mapRect(box.translated(-box.center()));
        if (!canvas.labels.isFree(turned)) continue;
        canvas.labels.block(turned);
        drawText(canvas.painter, at, Qt::AlignHCenter | Qt::AlignVCenter, name, letters, turned_deg);
    }
}

}  // namespace sagara::ui
