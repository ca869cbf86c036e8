#include <array>
#include <cmath>

#include "ui/widgets/ChartTexts.h"
#include "ui/widgets/SceneLayers.h"
#include "ui/widgets/ScreenLines.h"
#include "ui/widgets/ShipShape.h"

namespace sagara::ui {
namespace {

constexpr double kTick_px = 3.5;

/// Minutes between ticks: those that leave a dozen pixels on the way made good on average.
double tickStep_min(const ChartCanvas& canvas, const ChartTrack& track) {
    double way_m = 0.0;
    for (std::size_t i = 1; i < track.points.size(); ++i)
        way_m += core::distance(track.points[i - 1].position, track.points[i].position);
    const double minutes = (track.points.back().time_s - track.points.front().time_s) / 60.0;
    if (minutes <= 0.0 || way_m <= 0.0) return 0.0;
    const double perMinute_px = canvas.view.toPixels(way_m) / minutes;
    for (const double step : {1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0}) {
        if (step * perMinute_px >= 14.0) return step;
    }
    return 0.0;
}

void drawTick(ChartCanvas& canvas, QPointF from, QPointF to, double half_px) {
    const QPointF along = to - from;
    const double length = std::hypot(along.x(), along.y());
    if (length <= 0.0) return;
    const QPointF across = half_px / length * QPointF(-along.y(), along.x());
    canvas.painter.drawLine(to - across, to + across);
}

/// Ticks at whole minutes of the clock, every fifth one longer and with its time.
void drawTicks(ChartCanvas& canvas, const ChartTrack& track, double clockAtZero_s) {
    const double step_s = 60.0 * tickStep_min(canvas, track);
    if (step_s <= 0.0) return;
    const Lettering letters = canvas.letters(0.78, canvas.palette.track);
    QPointF lastTick(1e9, 1e9);
    for (std::size_t i = 1; i < track.points.size(); ++i) {
        const double before = std::floor((track.points[i - 1].time_s + clockAtZero_s) / step_s);
        const double now = std::floor((track.points[i].time_s + clockAtZero_s) / step_s);
        if (now <= before) continue;
        const QPointF to = canvas.view.toScreen(track.points[i].position);
        if (!canvas.frame.contains(to)) continue;
        if (std::hypot(to.x() - lastTick.x(), to.y() - lastTick.y()) < 6.0) continue;  // she lay still
        lastTick = to;
        const bool fifth = std::fmod(now, 5.0) == 0.0;
        canvas.painter.setPen(chartPen(canvas.palette.track, 1.4));
        drawTick(canvas, canvas.view.toScreen(track.points[i - 1].position), to,
                 fifth ? 1.6 * kTick_px : kTick_px);
        if (fifth)
            labelNear(canvas, to, 0.6 * canvas.letter_px, 1.5 * canvas.letter_px, {clockText(now * step_s)},
                      letters);
    }
}

void drawTrack(ChartCanvas& canvas, const ChartTrack& track) {
    std::vector<core::NorthEast> line;
    line.reserve(track.points.size());
    // points that fall on the same two pixels are one: an hour of a ship that lies at her berth is a dot
    const double fine_m = canvas.view.toMetres(1.5);
    for (std::size_t i = 0; i < track.points.size(); ++i) {
        const core::NorthEast p = track.points[i].position;
        if (line.empty() || i + 1 == track.points.size() || core::distance(line.back(), p) >= fine_m)
            line.push_back(p);
    }
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(track.ownShip ? chartPen(canvas.palette.track, 1.7)
                                        : chartPen(canvas.palette.target, 1.0));
    for (const QPolygonF& piece : screenPieces(canvas.view, line, canvas.clip())) {
        canvas.painter.drawPolyline(piece);
        if (!track.ownShip) continue;
        QPointF last(1e9, 1e9);
        for (const QPointF p : piece) {
            if (std::abs(p.x() - last.x()) + std::abs(p.y() - last.y()) < 10.0) continue;
            canvas.labels.avoid(p);
            last = p;
        }
    }
}

void drawPrediction(ChartCanvas& canvas, const ChartPrediction& prediction) {
    if (prediction.poses.size() < 2) return;
    std::vector<core::NorthEast> line;
    for (const ChartPose& pose : prediction.poses) line.push_back(pose.position);
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(dashedChartPen(canvas.palette.prediction, 1.8, 4.0, 3.0));
    for (const QPolygonF& piece : screenPieces(canvas.view, line, canvas.clip()))
        canvas.painter.drawPolyline(piece);
    const bool toScale = drawnToScale(canvas.view, prediction.length_m, canvas.letter_px);
    canvas.painter.setPen(chartPen(canvas.palette.prediction, toScale ? 1.2 : 1.6));
    const double begin_s = prediction.poses.front().time_s;
    double next_s = 60.0;
    for (std::size_t i = 1; i < prediction.poses.size(); ++i) {
        const ChartPose& pose = prediction.poses[i];
        if (pose.time_s - begin_s < next_s - 1e-6) continue;
        next_s += 60.0;
        const QPointF at = canvas.view.toScreen(pose.position);
        if (!canvas.holds(at)) continue;
        if (!toScale) {
            drawTick(canvas, canvas.view.toScreen(prediction.poses[i - 1].position), at, kTick_px);
            continue;
        }
        QPolygonF outline;
        for (const core::NorthEast p :
             shipOutline(pose.position, pose.heading_rad, prediction.length_m, prediction.beam_m))
            outline << canvas.view.toScreen(p);
        canvas.painter.drawPolygon(outline);
    }
}

}  // namespace

void drawTracks(ChartCanvas& canvas, const ChartScene& scene) {
    for (const ChartTrack& track : scene.tracks) {
        if (track.points.size() < 2) continue;
        drawTrack(canvas, track);
        if (track.ownShip) drawTicks(canvas, track, scene.clockAtZero_s);
    }
}

void drawPredictions(ChartCanvas& canvas, const ChartScene& scene) {
    for (const ChartPrediction& prediction : scene.predictions) drawPrediction(canvas, prediction);
}

}  // namespace sagara::ui
