#include "core/world/Contact.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace sagara::core {
namespace {

constexpr double kReach_m = 3.0;      // shore nearer than this to the outline is looked at in the tick
constexpr double kDeepest_m = 8.0;    // an overlap deeper than this is on the far side of something thin
constexpr double kBlow_radps = 6.0;   // natural frequency of a hard contact
constexpr double kHardDamping = 0.4;  // of critical
constexpr double kFenderDamping = 0.15;
constexpr double kFriction = 0.3;
constexpr double kFrictionSpeed_mps = 0.05;  // half of the friction at this sliding speed, more above

/// One overlapping point.
struct Point {
    ContactKind kind;
    BodyPoint where;
    NorthEast away;  ///< unit vector that takes the ship out of the overlap
    double depth_m;
    double stiffness_Npm;
    double damping_Nspm;
    NorthEast otherVelocity;
    double otherMass_kg;  ///< 0: does not move
    std::int32_t other;
    std::size_t body;  ///< what is touched: kShoreBody, kFenderBody or kFirstShipBody and on
};
constexpr std::size_t kFenderBody = 0, kShoreBody = 1, kFirstShipBody = 2;
constexpr std::size_t kMostBodies = kFirstShipBody + std::tuple_size_v<decltype(Obstacles::ships.items)>;

ContactKind kindOf(ShoreKind kind) {
    switch (kind) {
        case ShoreKind::Quay:
        case ShoreKind::Jetty:
            return ContactKind::Quay;
        case ShoreKind::Breakwater:
            return ContactKind::Breakwater;
        default:
            return ContactKind::Shore;
    }
}

bool inBox(BodyPoint p, BodyPoint halfSize, double margin_m) {
    return std::abs(p.x_m) < halfSize.x_m + margin_m && std::abs(p.y_m) < halfSize.y_m + margin_m;
}

/// Nearest point of a closed outline to p and whether p is inside.
struct OutlineHit {
    bool inside = false;
    double distance_m = 1e9;
    BodyPoint nearest;
};
OutlineHit hitOutline(std::span<const BodyPoint> outline, BodyPoint p) {
    OutlineHit hit;
    double least_m2 = 1e18;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const BodyPoint a = outline[j], b = outline[i];
        if ((a.y_m > p.y_m) != (b.y_m > p.y_m)) {
            const double x_m = a.x_m + (b.x_m - a.x_m) * (p.y_m - a.y_m) / (b.y_m - a.y_m);
            if (p.x_m < x_m) hit.inside = !hit.inside;
        }
        const NorthEast nearest = nearestPoint({{a.x_m, a.y_m}, {b.x_m, b.y_m}}, {p.x_m, p.y_m});
        const NorthEast off = nearest - NorthEast{p.x_m, p.y_m};
        if (dot(off, off) < least_m2) {
            least_m2 = dot(off, off);
            hit.nearest = {nearest.north_m, nearest.east_m};
        }
    }
    hit.distance_m = std::sqrt(least_m2);
    return hit;
}

struct Hardness {
    double stiffness_Npm;
    double damping_Nspm;
};
Hardness hardContact(double mass_kg) {
    const double stiffness = mass_kg * kBlow_radps * kBlow_radps;
    return {stiffness, 2.0 * kHardDamping * mass_kg * kBlow_radps};
}

template <typename Visit>
void visitShore(const Obstacles& obstacles, const ContactHull& hull, const HeadingFrame& frame,
                Visit&& visit) {
    const auto [stiffness, damping] = hardContact(hull.lateralMass_kg);
    for (const Obstacles::NearShore& near : obstacles.shore) {
        const BodyPoint where = hull.outline[near.vertex];
        const NorthEast p = frame.point(where);
        const Shore::Offset offset = Shore::offset(*near.piece, p);
        if (offset.distance_m >= 0.0 || offset.distance_m < -kDeepest_m) continue;
        const NorthEast away = (1.0 / -offset.distance_m) * (offset.nearest - p);
        visit(Point{near.kind, where, away, -offset.distance_m, stiffness, damping, {}, 0.0, 0, kShoreBody});
    }
    for (const Obstacles::NearCorner& near : obstacles.corners) {
        const BodyPoint corner = frame.pointInBody(near.piece->segment.a);
        if (!inBox(corner, hull.halfSize, 0.0)) continue;
        const OutlineHit hit = hitOutline(hull.outline, corner);
        if (!hit.inside || hit.distance_m < 1e-6) continue;
        const BodyPoint inward{(corner.x_m - hit.nearest.x_m) / hit.distance_m,
                               (corner.y_m - hit.nearest.y_m) / hit.distance_m};
        visit(Point{near.kind,
                    hit.nearest,
                    frame.vector(inward),
                    hit.distance_m,
                    stiffness,
                    damping,
                    {},
                    0.0,
                    0,
                    kShoreBody});
    }
}

template <typename Visit>
void visitFenders(const Obstacles& obstacles, const ContactHull& hull, const HeadingFrame& frame,
                  Visit&& visit) {
    for (const Obstacles::NearFender& near : obstacles.fenders) {
        const Fender& fender = *near.fender;
        const BodyPoint root = frame.pointInBody(fender.position), out = frame.vectorInBody(near.outward);
        // nearest crossing of the fender's axis with the outline
        double nearest_m = fender.thickness_m;
        BodyPoint where;
        for (std::size_t i = 0, j = hull.outline.size() - 1; i < hull.outline.size(); j = i++) {
            const BodyPoint a = hull.outline[j], b = hull.outline[i];
            const double sideA = (a.x_m - root.x_m) * out.y_m - (a.y_m - root.y_m) * out.x_m;
            const double sideB = (b.x_m - root.x_m) * out.y_m - (b.y_m - root.y_m) * out.x_m;
            if ((sideA > 0.0) == (sideB > 0.0)) continue;
            const double f = sideA / (sideA - sideB);
            const BodyPoint q{a.x_m + f * (b.x_m - a.x_m), a.y_m + f * (b.y_m - a.y_m)};
            const double along_m = (q.x_m - root.x_m) * out.x_m + (q.y_m - root.y_m) * out.y_m;
            if (along_m < nearest_m && along_m > -kDeepest_m) {
                nearest_m = along_m;
                where = q;
            }
        }
        if (nearest_m >= fender.thickness_m) continue;
        const double damping = kFenderDamping * std::sqrt(fender.stiffness_Npm * hull.lateralMass_kg);
        visit(Point{ContactKind::Fender,
                    where,
                    near.outward,
                    fender.thickness_m - nearest_m,
                    fender.stiffness_Npm,
                    damping,
                    {},
                    0.0,
                    0,
                    kFenderBody});
    }
}

template <typename Visit>
void visitShips(const Obstacles& obstacles, const ContactHull& hull, const HeadingFrame& frame,
                Visit&& visit) {
    std::size_t body = kFirstShipBody;
    for (const ShipObstacle& ship : obstacles.ships) {
        const auto [stiffness, damping] = hardContact(std::min(hull.lateralMass_kg, ship.mass_kg));
        const HeadingFrame theirs(ship.position, ship.heading_rad);
        for (const BodyPoint& vertex : hull.outline) {
            const BodyPoint p = theirs.pointInBody(frame.point(vertex));
            if (!inBox(p, ship.halfSize, 0.0)) continue;
            const OutlineHit hit = hitOutline(ship.outline, p);
            if (!hit.inside || hit.distance_m < 1e-6) continue;
            const NorthEast away = theirs.point(hit.nearest) - frame.point(vertex);
            visit(Point{ContactKind::Ship, vertex, (1.0 / hit.distance_m) * away, hit.distance_m, stiffness,
                        damping, ship.velocity, ship.mass_kg, ship.index, body});
        }
        for (const BodyPoint& vertex : ship.outline) {
            const BodyPoint p = frame.pointInBody(theirs.point(vertex));
            if (!inBox(p, hull.halfSize, 0.0)) continue;
            const OutlineHit hit = hitOutline(hull.outline, p);
            if (!hit.inside || hit.distance_m < 1e-6) continue;
            const BodyPoint inward{(p.x_m - hit.nearest.x_m) / hit.distance_m,
                                   (p.y_m - hit.nearest.y_m) / hit.distance_m};
            visit(Point{ContactKind::Ship, hit.nearest, frame.vector(inward), hit.distance_m, stiffness,
                        damping, ship.velocity, ship.mass_kg, ship.index, body});
        }
        ++body;
    }
}

/// Mass that a blow at a point along a line has to stop. A blow off the middle turns the ship instead of
/// stopping her: broadside the share k^2 / (k^2 + x^2), k = L/4.
double stoppedMass_kg(const ContactHull& hull, BodyPoint where, BodyPoint along) {
    const double lever_m = where.x_m * along.y_m - where.y_m * along.x_m;
    const double turning = 16.0 * lever_m * lever_m / (hull.length_m * hull.length_m);
    return 1.0 /
           (along.x_m * along.x_m / hull.mass_kg + (along.y_m * along.y_m + turning) / hull.lateralMass_kg);
}

template <typename Visit>
void visitAll(const Obstacles& obstacles, const ContactHull& hull, const HeadingFrame& frame, Visit&& visit) {
    visitShore(obstacles, hull, frame, visit);
    visitFenders(obstacles, hull, frame, visit);
    visitShips(obstacles, hull, frame, visit);
}

}  // namespace

const char* contactKindName(ContactKind kind) {
    switch (kind) {
        case ContactKind::Fender:
            return "fender";
        case ContactKind::Quay:
            return "quay";
        case ContactKind::Breakwater:
            return "breakwater";
        case ContactKind::Shore:
            return "shore";
        case ContactKind::Ship:
            return "ship";
    }
    return "";
}

ContactHull contactHull(const Hull& hull, double lateralMass_kg) {
    ContactHull c{outlineOf(hull.lengthOverall_m, hull.beam_m),
                  0.0,
                  {0.5 * hull.lengthOverall_m, 0.5 * hull.beam_m},
                  hull.lengthOverall_m,
                  hull.mass_kg(),
                  lateralMass_kg};
    for (const BodyPoint& p : c.outline) c.radius_m = std::max(c.radius_m, std::hypot(p.x_m, p.y_m));
    return c;
}

void findObstacles(const Area& area, const ContactHull& hull, const ShipMotion& m, Obstacles& found) {
    const double reach_m = hull.radius_m + kReach_m;
    const HeadingFrame frame(m.position(), m.heading_rad);
    bool shoreNear = false;
    area.shore.near(m.position(), reach_m, [&](const Shore::Piece& piece) {
        if (distanceTo(piece.segment, m.position()) > reach_m) return;
        shoreNear = true;
        const BodyPoint corner = frame.pointInBody(piece.segment.a);
        if (!inBox(corner, hull.halfSize, kReach_m) ||
            hitOutline(hull.outline, corner).distance_m >= kReach_m)
            return;
        const bool known =
            std::any_of(found.corners.begin(), found.corners.end(),
                        [&](const Obstacles::NearCorner& other) { return other.piece == &piece; });
        if (!known) found.corners.add({&piece, kindOf(area.shore.lines()[piece.line].kind)});
    });
    for (std::uint32_t i = 0; shoreNear && i < hull.outline.size(); ++i) {
        const NorthEast p = frame.point(hull.outline[i]);
        const Shore::Piece* nearest = nullptr;
        double nearest_m = kDeepest_m;
        area.shore.near(p, kDeepest_m, [&](const Shore::Piece& piece) {
            const double d_m = distanceTo(piece.segment, p);
            if (d_m < nearest_m) nearest_m = d_m, nearest = &piece;
        });
        if (!nearest || Shore::offset(*nearest, p).distance_m > kReach_m) continue;
        found.shore.add({i, nearest, kindOf(area.shore.lines()[nearest->line].kind)});
    }
    for (const Berth& berth : area.berths) {
        if (distanceTo(berth.face, m.position()) > reach_m) continue;
        for (const Fender& fender : berth.fenders) {
            if (distance(fender.position, m.position()) < reach_m)
                found.fenders.add({&fender, berth.outward()});
        }
    }
}

Load contactLoad(const Obstacles& obstacles, const ContactHull& hull, const ShipMotion& m,
                 NorthEast current) {
    const HeadingFrame frame(m.position(), m.heading_rad);
    // A hard body has the stiffness of one blow however many points touch it: they share it by their depth.
    // (A long side flat on a quay would else be as many times stiffer and more damped as it has points, too
    // much for the tick.)
    struct Overlap {
        double sum_m = 0.0, deepest_m = 0.0;
    };
    std::array<Overlap, kMostBodies> overlaps;
    const auto gather = [&](const Point& point) {
        Overlap& overlap = overlaps[point.body];
        overlap.sum_m += point.depth_m;
        overlap.deepest_m = std::max(overlap.deepest_m, point.depth_m);
    };
    visitShore(obstacles, hull, frame, gather);
    visitShips(obstacles, hull, frame, gather);
    Load sum;
    visitAll(obstacles, hull, frame, [&](const Point& point) {
        const NorthEast velocity = frame.vector(velocityAt(m, point.where)) + current - point.otherVelocity;
        const double closing_mps = -dot(velocity, point.away);
        const Overlap& overlap = overlaps[point.body];
        const bool fender = point.body == kFenderBody;
        const double share = fender ? 1.0 : point.depth_m / overlap.sum_m,
                     depth_m = fender ? point.depth_m : overlap.deepest_m;
        const double normal_N =
            share * std::max(0.0, point.stiffness_Npm * depth_m + point.damping_Nspm * closing_mps);
        const NorthEast sliding = velocity + closing_mps * point.away;
        const double slide_mps = length(sliding);
        const NorthEast force =
            normal_N * point.away + -kFriction * normal_N / (slide_mps + kFrictionSpeed_mps) * sliding;
        sum = sum + forceAt(point.where, 0.0, frame.vectorInBody(force));
    });
    return sum;
}

Touches findTouches(const Obstacles& obstacles, const ContactHull& hull, const ShipMotion& m,
                    NorthEast current) {
    const HeadingFrame frame(m.position(), m.heading_rad);
    Touches touches{};
    visitAll(obstacles, hull, frame, [&](const Point& point) {
        Touch& touch = touches[static_cast<std::size_t>(point.kind)];
        const NorthEast velocity = frame.vector(velocityAt(m, point.where)) + current - point.otherVelocity;
        const double closing_mps = -dot(velocity, point.away);
        if (touch.touching && closing_mps <= touch.approach_mps) return;
        const double own_kg = stoppedMass_kg(hull, point.where, frame.vectorInBody(point.away));
        const double mass_kg =
            point.otherMass_kg > 0.0 ? own_kg * point.otherMass_kg / (own_kg + point.otherMass_kg) : own_kg;
        const double speed_mps = std::max(0.0, closing_mps);
        touch = {true, frame.point(point.where), closing_mps, 0.5 * mass_kg * speed_mps * speed_mps,
                 point.other};
    });
    return touches;
}

}  // namespace sagara::core
