#include "ui/report/LegendEntries.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "ui/chart/Marks.h"
#include "ui/report/ChartSigns.h"
#include "ui/report/Format.h"
#include "ui/report/Text.h"
#include "ui/report/TrackMoments.h"

namespace sagara::report {
namespace {

using core::MarkKind;

const TextStyle kNameStyle{7.0, colour::kInk, false, true};
const TextStyle kNumberStyle{6.5, colour::kFailed, true};

void drawSample(QPainter& painter, QPointF middle, const QPen& pen) {
    painter.setPen(pen);
    painter.drawLine(middle - QPointF(3.5, 0.0), middle + QPointF(3.5, 0.0));
}

void drawCentred(QPainter& painter, QPointF middle, const QString& text, const TextStyle& style) {
    drawText(painter, middle, Qt::AlignHCenter | Qt::AlignVCenter, text, style);
}

LegendEntry lineEntry(const QPen& pen, const QString& meaning) {
    return {[pen](QPainter& painter, QPointF p) { drawSample(painter, p, pen); }, meaning};
}

QString intervalText(double interval_s) {
    return interval_s < 60.0 ? tr("%1 s").arg(std::lround(interval_s))
                             : tr("%1 min").arg(shortNumber(interval_s / 60.0, 1));
}

LegendEntry shipEntry(double interval_s) {
    const auto draw = [](QPainter& painter, QPointF p) {
        drawSample(painter, p, trackPen());
        painter.setPen(linePen(colour::kInk, 0.12));
        painter.setBrush(colour::kHull);
        painter.drawPolygon(QPolygonF{p + QPointF(-1.6, -0.4), p + QPointF(0.8, -0.4), p + QPointF(1.6, 0.0),
                                      p + QPointF(0.8, 0.4), p + QPointF(-1.6, 0.4)});
    };
    return {draw, tr("track; the ship to scale every %1").arg(intervalText(interval_s))};
}

LegendEntry tickEntry(const RunReport& report) {
    const auto draw = [](QPainter& painter, QPointF p) {
        drawSample(painter, p, trackPen());
        painter.setPen(tickPen());
        painter.drawLine(p - QPointF(0.0, 1.1), p + QPointF(0.0, 1.1));
    };
    return {draw, tr("every %1, mm:ss since start").arg(intervalText(tickInterval_s(report.track)))};
}

LegendEntry routeEntry() {
    const auto draw = [](QPainter& painter, QPointF p) {
        drawSample(painter, p, routePen());
        drawWaypointSign(painter, p, 1.0);
    };
    return {draw, tr("route and waypoint")};
}

LegendEntry corridorEntry() {
    const auto draw = [](QPainter& painter, QPointF p) {
        painter.setPen(corridorEdgePen());
        painter.setBrush(colour::kCorridor);
        painter.drawRect(QRectF(p.x() - 3.5, p.y() - 1.2, 7.0, 2.4));
    };
    return {draw, tr("cross-track limits, port and starboard")};
}

LegendEntry deductionEntry() {
    const auto draw = [](QPainter& painter, QPointF p) {
        drawDeductionCross(painter, p - QPointF(2.4, 0.0));
        drawDeductionCapsule(painter, {p.x() - 0.8, p.y() - 1.7, 3.4, 3.4});
        drawCentred(painter, p + QPointF(0.9, 0.0), QStringLiteral("1"), kNumberStyle);
    };
    return {draw, tr("deduction, number in the list")};
}

LegendEntry anchorEntry() {
    return {[](QPainter& painter, QPointF p) { drawAnchorSign(painter, p, 1.5); }, tr("anchor let go")};
}

void addRun(std::vector<LegendEntry>& entries, const RunReport& report, double interval_s) {
    if (!report.track.empty()) entries.insert(entries.end(), {shipEntry(interval_s), tickEntry(report)});
    if (!report.route.waypoints.empty()) entries.insert(entries.end(), {routeEntry(), corridorEntry()});
    if (!report.deductions.empty()) entries.push_back(deductionEntry());
    if (!report.anchors.empty()) entries.push_back(anchorEntry());
}

void addTraffic(std::vector<LegendEntry>& entries, const RunReport& report) {
    const auto hostile = [](const OtherTrack& other) { return other.hostile; };
    if (!std::all_of(report.others.begin(), report.others.end(), hostile)) {
        entries.push_back(lineEntry(otherTrackPen(false), tr("other ship, to where she was last")));
    }
    if (std::any_of(report.others.begin(), report.others.end(), hostile)) {
        entries.push_back(lineEntry(otherTrackPen(true), tr("hostile craft")));
    }
}

void addDepths(std::vector<LegendEntry>& entries, const RunReport& report) {
    if (report.contours.empty()) return;
    const QString meaning = report.depthDatum.empty()
                                ? tr("depth contour, m")
                                : tr("depth contour, m below %1").arg(fromStd(report.depthDatum));
    entries.push_back(lineEntry(linePen(colour::kContour, 0.25), meaning));
}

/// The first mark of one of the kinds stands for all of them.
void addMark(std::vector<LegendEntry>& entries, const RunReport& report,
             std::initializer_list<MarkKind> kinds, const QString& meaning) {
    const auto found = std::find_if(report.marks.begin(), report.marks.end(), [&](const ChartMark& mark) {
        return std::find(kinds.begin(), kinds.end(), mark.kind) != kinds.end();
    });
    if (found == report.marks.end()) return;
    entries.push_back(
        {[mark = *found](QPainter& painter, QPointF p) { drawMark(painter, p, mark, 2.4); }, meaning});
}

void addMarks(std::vector<LegendEntry>& entries, const RunReport& report) {
    addMark(entries, report, {MarkKind::LateralPort}, tr("port-hand mark"));
    addMark(entries, report, {MarkKind::LateralStarboard}, tr("starboard-hand mark"));
    addMark(
        entries, report,
        {MarkKind::CardinalNorth, MarkKind::CardinalEast, MarkKind::CardinalSouth, MarkKind::CardinalWest},
        tr("cardinal mark"));
    addMark(entries, report, {MarkKind::IsolatedDanger}, tr("isolated danger"));
    addMark(entries, report, {MarkKind::SafeWater}, tr("safe-water mark"));
    addMark(entries, report, {MarkKind::Special}, tr("special mark"));
    addMark(entries, report, {MarkKind::Lighthouse}, tr("lighthouse"));
    addMark(entries, report, {MarkKind::Leading}, tr("leading mark"));
    addMark(entries, report, {MarkKind::Beacon}, tr("beacon"));
}

void addFiction(std::vector<LegendEntry>& entries, const RunReport& report) {
    const auto fictional = [](const ChartMark& mark) { return mark.fictional; };
    if (std::none_of(report.marks.begin(), report.marks.end(), fictional)) return;
    entries.push_back({[](QPainter& painter, QPointF p) { drawCentred(painter, p, tr("Name"), kNameStyle); },
                       tr("name in italics: fictional mark")});
}

}  // namespace

std::vector<LegendEntry> legendEntries(const RunReport& report, double interval_s) {
    std::vector<LegendEntry> entries;
    addRun(entries, report, interval_s);
    addTraffic(entries, report);
    addDepths(entries, report);
    addMarks(entries, report);
    addFiction(entries, report);
    return entries;
}

}  // namespace sagara::report
