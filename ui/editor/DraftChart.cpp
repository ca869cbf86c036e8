#include "ui/editor/DraftChart.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "ui/editor/DraftMarks.h"
#include "ui/editor/FieldText.h"

namespace sagara::ui::editor {
namespace {

using core::NorthEast;
using Kind = DraftHandle::Kind;

struct Pose {
    NorthEast at;
    double heading_rad = 0.0;
    double beyond_m = 0.0;  ///< of midship from the quay's face
};

class Drawer {
public:
    Drawer(const EditorContext& context, const std::string& section)
        : m_context(context),
          m_document(context.draft().document()),
          m_area(*context.area()),
          m_section(section) {}

    DraftPicture draw() {
        drawShips();
        drawRoute();
        drawMarks();
        drawTraffic();
        drawEvents();
        drawTasks();
        drawCriteria();
        for (std::size_t i = 0; i < m_picture.handles.size(); ++i)
            m_picture.scene.handles.push_back({static_cast<int>(i), m_picture.handles[i].position,
                                               m_picture.handles[i].hint, m_picture.handles[i].open});
        return std::move(m_picture);
    }

private:
    std::optional<NorthEast> point(const std::string& path) const {
        const auto place = positionOf(find(m_document, path));
        return place ? std::optional(m_area.frame.toLocal(*place)) : std::nullopt;
    }
    std::optional<NorthEast> place(const std::string& path) const {
        if (const core::Place* named = m_area.findPlace(textAt(m_document, path))) return named->position;
        return point(path);
    }
    bool open(const char* section) const { return m_section == section; }
    bool chosen(const std::string& row) const { return within(m_context.selected(), row); }
    QString name(const std::string& row, const char* key) const {
        return QString::fromStdString(textAt(m_document, join(row, key)));
    }
    void handle(Kind kind, std::string path, NorthEast position, const QString& hint, NorthEast centre = {}) {
        m_picture.handles.push_back({kind, std::move(path), position, centre, hint, false});
    }

    std::optional<Pose> shipPose(const std::string& row, double beam_m) const {
        if (!find(m_document, join(row, "berth"))) {
            const auto at = point(join(row, "at"));
            if (!at) return std::nullopt;
            return Pose{*at, core::kDegree_rad * numberAt(m_document, join(row, "heading_deg"), 0.0)};
        }
        const core::Berth* berth = m_area.findBerth(textAt(m_document, join(row, "berth.id")));
        if (!berth) return std::nullopt;
        double off_m = 0.5 * beam_m;
        for (const core::Fender& f : berth->fenders) off_m = std::max(off_m, f.thickness_m + 0.5 * beam_m);
        const double along_m = numberAt(m_document, join(row, "berth.along_m"), 0.0);
        const bool port = textAt(m_document, join(row, "berth.side")) == "port";
        const double face_rad = core::bearing_rad(berth->face.a, berth->face.b);
        return Pose{berth->face.a + along_m * berth->along() + off_m * berth->outward(),
                    face_rad + (port ? 0.0 : core::kPi), off_m};
    }

    void drawShips() {
        for (std::size_t i = 0; i < sizeAt(m_document, "ownShips"); ++i) {
            const std::string row = join("ownShips", i);
            const core::Vessel* vessel = m_context.vesselAt(row);
            const double length_m = vessel ? vessel->hull.lengthOverall_m : 50.0,
                         beam_m = vessel ? vessel->hull.beam_m : 8.0;
            const auto pose = shipPose(row, beam_m);
            if (!pose) continue;
            ChartShip ship;
            ship.id = static_cast<int>(i);
            ship.name = name(row, "name");
            ship.position = pose->at;
            ship.heading_rad = pose->heading_rad;
            ship.length_m = length_m;
            ship.beam_m = beam_m;
            const bool alongside = find(m_document, join(row, "berth")) != nullptr;
            const double speed_mps = core::kKnot_mps * numberAt(m_document, join(row, "speed_kn"), 0.0);
            if (!alongside) ship.overGround_mps = speed_mps * core::unitVector(pose->heading_rad);
            m_picture.scene.ownShips.push_back(ship);
            if (!open("ownShips")) continue;
            handle(alongside ? Kind::ShipAtBerth : Kind::Ship, row, pose->at,
                   alongside ? words("Drag %1 along the quay, or to another").arg(ship.name)
                             : words("Drag %1").arg(ship.name));
            if (alongside) continue;
            const NorthEast ahead =
                pose->at + std::max(150.0, 2.0 * length_m) * core::unitVector(pose->heading_rad);
            handle(Kind::Heading, row, ahead, words("Drag to turn %1").arg(ship.name), pose->at);
        }
    }

    void drawRoute() {
        core::Route& route = m_picture.scene.route;
        for (std::size_t i = 0; i < sizeAt(m_document, "route.waypoints"); ++i) {
            const std::string row = join("route.waypoints", i);
            const auto at = point(join(row, "at"));
            if (!at) continue;
            core::Route::Waypoint w;
            w.name = textAt(m_document, join(row, "name"));
            w.position = *at;
            w.turnRadius_m = core::kNauticalMile_m * numberAt(m_document, join(row, "radius_M"), 0.0);
            w.portLimit_m = core::kNauticalMile_m * numberAt(m_document, join(row, "portXtd_M"), 0.1);
            w.starboardLimit_m =
                core::kNauticalMile_m * numberAt(m_document, join(row, "starboardXtd_M"), 0.1);
            w.speedMax_mps = core::kKnot_mps * numberAt(m_document, join(row, "speedMax_kn"), 60.0);
            if (!route.waypoints.empty() && core::distance(route.waypoints.back().position, w.position) < 1.0)
                w.position.north_m += 1.0;  // a path cannot be made of two waypoints in one place
            route.waypoints.push_back(w);
            if (open("route"))
                handle(Kind::Point, join(row, "at"), *at,
                       words("Waypoint %1 %2").arg(i + 1).arg(name(row, "name")));
        }
    }

    void drawMarks() {
        m_picture.scene.ialaRegion = m_area.ialaRegion;
        for (std::size_t i = 0; i < sizeAt(m_document, "marks"); ++i) {
            const std::string row = join("marks", i), at = join(row, "at");
            const auto place = point(at);
            core::Mark mark = markOf(*find(m_document, row), m_area.frame);
            mark.position = place.value_or(NorthEast{1e7, 1e7});  // keeps its place in the list
            m_picture.scene.marks.push_back(std::move(mark));
            if (!place || !open("marks")) continue;
            handle(Kind::Point, at, *place, words("Drag %1").arg(name(row, "name")));
            m_picture.handles.back().open = true;
        }
    }

    void drawTraffic() {
        for (std::size_t i = 0; i < sizeAt(m_document, "traffic"); ++i) {
            const std::string row = join("traffic", i), points = join(row, "route");
            std::vector<NorthEast> way;
            for (std::size_t k = 0; k < sizeAt(m_document, points); ++k) {
                const std::string at = join(join(points, k), "at");
                const auto p = point(at);
                if (!p) continue;
                way.push_back(*p);
                if (open("traffic") && (k == 0 || chosen(row)))
                    handle(Kind::Point, at, *p, words("%1, point %2").arg(name(row, "name")).arg(k + 1));
            }
            ChartShip ship;
            ship.id = static_cast<int>(i);
            ship.name = name(row, "name");
            ship.length_m = numberAt(m_document, join(row, "length_m"), 10.0);
            ship.beam_m = numberAt(m_document, join(row, "beam_m"), 3.0);
            ship.hostile = textAt(m_document, join(row, "behaviour")) == "hostile";
            if (way.empty()) {  // keeps its place in the list: a pick names it by number
                ship.length_m = ship.beam_m = 0.0;
                ship.position = {1e7, 1e7};
            } else {
                ship.position = way.front();
                if (way.size() > 1) ship.heading_rad = core::bearing_rad(way[0], way[1]);
            }
            m_picture.scene.targets.push_back(ship);
            if (way.size() < 2 || !(open("traffic") || open("dry-run"))) continue;
            if (textAt(m_document, join(row, "behaviour")) == "circuit") way.push_back(way.front());
            ChartTrack track;
            track.ownShip = false;
            for (const NorthEast p : way) track.points.push_back({0.0, p});
            m_picture.scene.tracks.push_back(std::move(track));
        }
    }

    void circle(const QString& title, ChartZone::Kind kind, const std::string& placePath,
                const std::string& radiusPath, bool miles, bool draggable) {
        const auto at = place(placePath);
        if (!at) return;
        ChartZone zone;
        zone.id = static_cast<int>(m_picture.scene.zones.size());
        zone.name = title;
        zone.kind = kind;
        zone.centre = *at;
        zone.radius_m = (miles ? core::kNauticalMile_m : 1.0) * numberAt(m_document, radiusPath, 0.0);
        if (zone.radius_m > 0.0) m_picture.scene.zones.push_back(zone);
        if (!draggable) return;
        handle(Kind::Place, placePath, *at, words("%1: drag; near a named place it takes that").arg(title));
        if (zone.radius_m > 0.0)
            handle(miles ? Kind::RadiusMiles : Kind::RadiusMetres, radiusPath,
                   *at + NorthEast{0.0, zone.radius_m}, words("%1: drag to change the radius").arg(title),
                   *at);
    }

    void gate(const QString& title, const std::string& between) {
        const auto a = place(join(between, std::size_t{0})), b = place(join(between, std::size_t{1}));
        if (!a || !b) return;
        ChartZone zone;
        zone.id = static_cast<int>(m_picture.scene.zones.size());
        zone.name = title;
        zone.corners = {*a, *b};
        m_picture.scene.zones.push_back(zone);
        if (!open("tasks")) return;
        for (std::size_t i = 0; i < 2; ++i)
            handle(Kind::Place, join(between, i), zone.corners[i],
                   words("%1: drag; near a named place it takes that").arg(title));
    }

    void drawEvents() {
        for (std::size_t i = 0; i < sizeAt(m_document, "events"); ++i) {
            const std::string row = join("events", i);
            circle(name(row, "title"), ChartZone::Kind::Task, join(row, "when.near"),
                   join(row, "when.within_M"), true, open("events"));
        }
    }

    void drawTasks() {
        for (std::size_t i = 0; i < sizeAt(m_document, "mission.tasks"); ++i) {
            const std::string row = join("mission.tasks", i), kind = textAt(m_document, join(row, "kind"));
            const QString title = name(row, "title");
            if (kind == "gate") gate(title, join(row, "between"));
            if (kind == "transit")
                circle(title, ChartZone::Kind::Task, join(row, "to"), join(row, "within_M"), true,
                       open("tasks"));
            if (kind == "anchor")
                circle(title, ChartZone::Kind::Task, join(row, "at"), join(row, "within_m"), false,
                       open("tasks"));
        }
    }

    void drawCriteria() {
        if (!open("criteria")) return;
        for (std::size_t i = 0; i < sizeAt(m_document, "mission.criteria"); ++i) {
            const std::string row = join("mission.criteria", i), zones = join(row, "zones");
            if (!chosen(row)) continue;
            for (std::size_t k = 0; k < sizeAt(m_document, zones); ++k) {
                const std::string zone = join(zones, k);
                circle(words("%1 kn").arg(numberAt(m_document, join(zone, "speed_kn"), 0.0)),
                       ChartZone::Kind::Limit, join(zone, "near"), join(zone, "within_M"), true, true);
            }
            if (textAt(m_document, join(row, "kind")) == "anchor-place")
                circle(name(row, "title"), ChartZone::Kind::Limit, join(row, "at"), join(row, "limit_m"),
                       false, true);
        }
    }

    const EditorContext& m_context;
    const Json& m_document;
    const core::Area& m_area;
    const std::string& m_section;
    DraftPicture m_picture;
};

/// Along the nearest quay, and not beyond its ends.
void dragAlongside(Json& document, const core::Area& area, const std::string& ship, NorthEast to) {
    const core::Berth* nearest = nullptr;
    double off_m = 0.0;
    for (const core::Berth& b : area.berths) {
        const double d_m = core::distanceTo(b.face, to);
        if (nearest && d_m >= off_m) continue;
        nearest = &b;
        off_m = d_m;
    }
    if (!nearest) return;
    const double along_m = std::clamp(core::dot(to - nearest->face.a, nearest->along()), 0.0,
                                      core::distance(nearest->face.a, nearest->face.b));
    put(document, join(ship, "berth.id"), nearest->id);
    put(document, join(ship, "berth.along_m"), std::round(along_m));
}

/// The nearest, or null.
const core::Place* placeWithin(const core::Area& area, NorthEast at, double reach_m) {
    const core::Place* nearest = nullptr;
    for (const core::Place& place : area.places) {
        const double away_m = core::distance(place.position, at);
        if (away_m > reach_m) continue;
        nearest = &place;
        reach_m = away_m;
    }
    return nearest;
}

}  // namespace

DraftPicture pictureOf(const EditorContext& context, const std::string& section) {
    if (!context.area()) return {};
    return Drawer(context, section).draw();
}

void drag(Json& document, const core::Area& area, const DraftHandle& handle, NorthEast to, double snap_m) {
    const double from_m = core::distance(handle.centre, to);
    switch (handle.kind) {
        case Kind::Point:
            put(document, handle.path, positionJson(area.frame.toGeo(to)));
            break;
        case Kind::Ship:
            put(document, join(handle.path, "at"), positionJson(area.frame.toGeo(to)));
            break;
        case Kind::Heading: {
            const double heading_deg =
                core::wrapTwoPi(core::bearing_rad(handle.centre, to)) / core::kDegree_rad;
            put(document, join(handle.path, "heading_deg"), std::fmod(std::round(heading_deg), 360.0));
            break;
        }
        case Kind::ShipAtBerth:
            dragAlongside(document, area, handle.path, to);
            break;
        case Kind::Place: {
            const core::Place* const named = placeWithin(area, to, snap_m);
            put(document, handle.path, named ? Json(named->id) : positionJson(area.frame.toGeo(to)));
            break;
        }
        case Kind::RadiusMiles:
            put(document, handle.path,
                std::max(0.01, std::round(100.0 * from_m / core::kNauticalMile_m) / 100.0));
            break;
        case Kind::RadiusMetres:
            put(document, handle.path, std::max(1.0, std::round(from_m)));
            break;
    }
}

}  // namespace sagara::ui::editor
