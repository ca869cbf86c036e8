#include "ui/widgets/ChartPick.h"

#include <cmath>

#include "core/base/Shapes.h"
#include "ui/widgets/ChartTexts.h"
#include "ui/widgets/ScreenText.h"
#include "ui/widgets/ShipShape.h"

namespace sagara::ui {
namespace {

using Kind = ChartPick::Kind;

/// Looks at one list after the other and keeps the nearest of the first list that has something in reach.
class Search {
public:
    Search(const ChartTransform& view, QPointF at, double reach_px)
        : m_place(view.toChart(at)), m_reach_m(view.toMetres(reach_px)) {}

    core::NorthEast place() const { return m_place; }
    /// `distance_m`: 0 when right on it.
    void offer(Kind kind, std::size_t index, core::NorthEast position, double distance_m) {
        if (distance_m > m_reach_m || (m_found.kind != Kind::Nothing && m_found.kind != kind)) return;
        if (m_found.kind == kind && distance_m >= m_distance_m) return;
        m_found = {kind, index, position, {}};
        m_distance_m = distance_m;
    }
    void offerPoint(Kind kind, std::size_t index, core::NorthEast position) {
        offer(kind, index, position, core::distance(position, m_place));
    }
    ChartPick found() const { return m_found; }

private:
    core::NorthEast m_place;
    double m_reach_m;
    ChartPick m_found;
    double m_distance_m = 0.0;
};

void offerShips(Search& search, Kind kind, const std::vector<ChartShip>& ships) {
    for (std::size_t i = 0; i < ships.size(); ++i) {
        const ChartShip& ship = ships[i];
        const bool onHull = core::contains(
            shipOutline(ship.position, ship.heading_rad, ship.length_m, ship.beam_m), search.place());
        search.offer(kind, i, ship.position, onHull ? 0.0 : core::distance(ship.position, search.place()));
    }
}

bool inZone(const ChartZone& zone, core::NorthEast p) {
    if (zone.corners.empty()) return core::distance(zone.centre, p) <= zone.radius_m;
    return zone.corners.size() > 2 && core::contains(zone.corners, p);
}

void offerZones(Search& search, const ChartScene& scene, ChartLayers shown) {
    for (std::size_t i = 0; i < scene.zones.size(); ++i) {
        const ChartZone& zone = scene.zones[i];
        const bool limit = zone.kind == ChartZone::Kind::Limit;
        if (!shown.testFlag(limit ? ChartLayer::SafetyLimits : ChartLayer::Zones)) continue;
        if (zone.corners.size() == 2) {
            search.offer(Kind::Zone, i, zone.corners[0],
                         core::distanceTo({zone.corners[0], zone.corners[1]}, search.place()));
        } else if (inZone(zone, search.place())) {
            search.offer(Kind::Zone, i, zone.corners.empty() ? zone.centre : zone.corners[0], 0.0);
        }
    }
}

void offerScene(Search& search, const ChartScene& scene, ChartLayers shown) {
    if (shown.testFlag(ChartLayer::OwnShips)) offerShips(search, Kind::OwnShip, scene.ownShips);
    if (shown.testFlag(ChartLayer::Targets)) offerShips(search, Kind::Target, scene.targets);
    if (!shown.testFlag(ChartLayer::Route)) return;
    for (std::size_t i = 0; i < scene.route.waypoints.size(); ++i)
        search.offerPoint(Kind::Waypoint, i, scene.route.waypoints[i].position);
}

void offerArea(Search& search, const core::Area& area, ChartLayers shown) {
    if (shown.testFlag(ChartLayer::Berths)) {
        for (std::size_t i = 0; i < area.berths.size(); ++i)
            search.offer(Kind::Berth, i, 0.5 * (area.berths[i].face.a + area.berths[i].face.b),
                         core::distanceTo(area.berths[i].face, search.place()));
    }
    if (!shown.testFlag(ChartLayer::Places)) return;
    for (std::size_t i = 0; i < area.places.size(); ++i)
        search.offerPoint(Kind::Place, i, area.places[i].position);
}

QString waypointText(const ChartScene& scene, std::size_t i) {
    const core::Route::Waypoint& w = scene.route.waypoints[i];
    QString text = tr("Waypoint %1").arg(i + 1);
    if (!w.name.empty()) text += QStringLiteral(": ") + QString::fromStdString(w.name);
    if (i > 0 && w.speedMax_mps > 0.0)
        text += u'\n' + tr("%1 at most on the leg to it").arg(speedText(w.speedMax_mps));
    return text;
}

QString textOf(const ChartPick& pick, const PreparedChart& chart, const ChartScene& scene) {
    const core::LocalFrame frame = chart.area ? chart.area->frame : core::LocalFrame({});
    switch (pick.kind) {
        case Kind::OwnShip:
            return shipText(frame, scene.ownShips[pick.index]);
        case Kind::Target:
            return shipText(frame, scene.targets[pick.index]);
        case Kind::Waypoint:
            return waypointText(scene, pick.index);
        case Kind::SceneMark:
            return markText(scene.marks[pick.index]);
        case Kind::Mark:
            return markText(chart.area->marks[pick.index]);
        case Kind::Anchor:
            return scene.anchors[pick.index].name;
        case Kind::Berth:
            return berthText(chart.area->berths[pick.index], QString::fromStdString(chart.area->depthDatum));
        case Kind::Place:
            return QString::fromStdString(chart.area->places[pick.index].name);
        case Kind::Zone:
            return scene.zones[pick.index].name;
        case Kind::Nothing:
            break;
    }
    return {};
}

}  // namespace

ChartPick pickOnChart(const PreparedChart& chart, const ChartScene& scene, ChartLayers shown,
                      const ChartTransform& view, QPointF at, double reach_px) {
    Search search(view, at, reach_px);
    offerScene(search, scene, shown);
    if (shown.testFlag(ChartLayer::Marks)) {
        for (std::size_t i = 0; i < scene.marks.size(); ++i)
            search.offerPoint(Kind::SceneMark, i, scene.marks[i].position);
    }
    if (chart.area && shown.testFlag(ChartLayer::Marks)) {
        for (std::size_t i = 0; i < chart.area->marks.size(); ++i)
            search.offerPoint(Kind::Mark, i, chart.area->marks[i].position);
    }
    if (shown.testFlag(ChartLayer::Anchors)) {
        for (std::size_t i = 0; i < scene.anchors.size(); ++i)
            search.offerPoint(Kind::Anchor, i, scene.anchors[i].position);
    }
    if (chart.area) offerArea(search, *chart.area, shown);
    offerZones(search, scene, shown);
    ChartPick pick = search.found();
    pick.text = textOf(pick, chart, scene);
    return pick;
}

}  // namespace sagara::ui
