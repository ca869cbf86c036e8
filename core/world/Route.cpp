#include "core/world/Route.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/Angle.h"

namespace sagara::core {
namespace {

/// Point reached on a piece of constant curvature.
NorthEast advance(NorthEast start, double course_rad, double curvature_perM, double within_m) {
    if (curvature_perM == 0.0) return start + within_m * unitVector(course_rad);
    const double turned_rad = curvature_perM * within_m;
    // chord of the arc
    const double chord_m = 2.0 / curvature_perM * std::sin(0.5 * turned_rad);
    return start + chord_m * unitVector(course_rad + 0.5 * turned_rad);
}

}  // namespace

RoutePath::RoutePath(const Route& route) {
    const auto& w = route.waypoints;
    assert(w.size() >= 2);
    m_alongOf.assign(w.size(), 0.0);
    // tangent lengths of the arcs, cut where two of them would overlap on a leg
    std::vector<double> tangent_m(w.size(), 0.0), turn_rad(w.size(), 0.0);
    for (std::size_t i = 1; i + 1 < w.size(); ++i) {
        turn_rad[i] = wrapPi(bearing_rad(w[i].position, w[i + 1].position) -
                             bearing_rad(w[i - 1].position, w[i].position));
        tangent_m[i] =
            w[i].turnRadius_m * std::tan(0.5 * std::min(std::abs(turn_rad[i]), 175.0 * kDegree_rad));
    }
    for (std::size_t i = 1; i < w.size(); ++i) {
        const double leg_m = distance(w[i - 1].position, w[i].position),
                     wanted_m = tangent_m[i - 1] + tangent_m[i];
        if (wanted_m <= leg_m) continue;
        tangent_m[i - 1] *= leg_m / wanted_m;
        tangent_m[i] *= leg_m / wanted_m;
    }
    double along_m = 0.0;
    const auto add = [&](NorthEast start, double course_rad, double length_m, double curvature_perM) {
        m_pieces.push_back({start, course_rad, length_m, curvature_perM, along_m});
        along_m += length_m;
    };
    for (std::size_t i = 1; i < w.size(); ++i) {
        const double course_rad = bearing_rad(w[i - 1].position, w[i].position);
        const NorthEast direction = unitVector(course_rad);
        const NorthEast begin = w[i - 1].position + tangent_m[i - 1] * direction;
        const double straight_m =
            distance(w[i - 1].position, w[i].position) - tangent_m[i - 1] - tangent_m[i];
        add(begin, course_rad, std::max(0.0, straight_m), 0.0);
        m_alongOf[i] = along_m;
        if (tangent_m[i] <= 0.0 || turn_rad[i] == 0.0) continue;
        const double radius_m = tangent_m[i] / std::tan(0.5 * std::abs(turn_rad[i]));
        const double arc_m = radius_m * std::abs(turn_rad[i]);
        m_alongOf[i] = along_m + 0.5 * arc_m;
        add(w[i].position - tangent_m[i] * direction, course_rad, arc_m,
            std::copysign(1.0 / radius_m, turn_rad[i]));
    }
    m_length_m = along_m;
}

RoutePath::Place RoutePath::placeOn(const Piece& piece, double within_m) const {
    Place place;
    place.along_m = piece.from_m + within_m;
    place.course_rad = wrapTwoPi(piece.course_rad + piece.curvature_perM * within_m);
    place.curvature_perM = piece.curvature_perM;
    place.leg = m_alongOf.size() - 1;
    while (place.leg > 1 && place.along_m < m_alongOf[place.leg - 1]) --place.leg;
    return place;
}

RoutePath::Place RoutePath::nearest(NorthEast p, double from_m, double behind_m, double ahead_m) const {
    const double low_m = std::max(0.0, from_m - behind_m), high_m = std::min(m_length_m, from_m + ahead_m);
    Place best;
    double best_m = 1e18;
    for (const Piece& piece : m_pieces) {
        if (piece.from_m + piece.length_m < low_m || piece.from_m > high_m) continue;
        double within_m;
        if (piece.curvature_perM == 0.0) {
            within_m = dot(p - piece.start, unitVector(piece.course_rad));
        } else {
            const NorthEast centre =
                piece.start + (1.0 / piece.curvature_perM) * turnedRight(unitVector(piece.course_rad));
            const double turned_rad = wrapPi(bearing_rad(centre, p) - bearing_rad(centre, piece.start));
            within_m = turned_rad / piece.curvature_perM;
        }
        const double first_m = std::max(0.0, low_m - piece.from_m),
                     last_m = std::min(piece.length_m, high_m - piece.from_m);
        within_m = std::clamp(within_m, first_m, std::max(first_m, last_m));
        const NorthEast q = advance(piece.start, piece.course_rad, piece.curvature_perM, within_m);
        const double d_m = distance(q, p);
        if (d_m >= best_m) continue;
        best_m = d_m;
        best = placeOn(piece, within_m);
        const double side_m = cross(unitVector(best.course_rad), p - q);
        const bool atAnEnd = best.along_m <= 0.0 || best.along_m >= m_length_m;
        best.offTrack_m = atAnEnd ? side_m : std::copysign(d_m, side_m);
    }
    return best;
}

RoutePath::Place RoutePath::at(double along_m) const {
    const double s = std::clamp(along_m, 0.0, m_length_m);
    std::size_t i = 0;
    while (i + 1 < m_pieces.size() && m_pieces[i + 1].from_m <= s) ++i;
    return placeOn(m_pieces[i], std::min(s - m_pieces[i].from_m, m_pieces[i].length_m));
}

NorthEast RoutePath::pointAt(double along_m) const {
    const double s = std::clamp(along_m, 0.0, m_length_m);
    std::size_t i = 0;
    while (i + 1 < m_pieces.size() && m_pieces[i + 1].from_m <= s) ++i;
    const Piece& piece = m_pieces[i];
    return advance(piece.start, piece.course_rad, piece.curvature_perM,
                   std::min(s - piece.from_m, piece.length_m));
}

}  // namespace sagara::core
