#pragma once

#include <string>
#include <vector>

#include "core/base/Planar.h"

namespace sagara::core {

/// A planned route, as RTZ (IEC 61174) gives it, in frame N.
struct Route {
    struct Waypoint {
        std::string name;
        NorthEast position;
        double turnRadius_m = 0.0;
        // of the leg that ends here:
        double portLimit_m = 0.0;       ///< cross-track limit to port
        double starboardLimit_m = 0.0;  ///< cross-track limit to starboard
        double speedMax_mps = 0.0;
    };
    std::string name;
    std::vector<Waypoint> waypoints;
};

/// The line a ship follows: straight legs joined by arcs of each waypoint's turn radius. Where two legs are
/// too short for their radius the arc is made as large as fits. Immutable.
class RoutePath {
public:
    RoutePath() = default;
    /// At least two waypoints, no two alike.
    explicit RoutePath(const Route& route);

    struct Place {
        double along_m = 0.0;  ///< from the first waypoint
        /// To starboard of the track is positive; before and beyond it, of the end leg drawn on.
        double offTrack_m = 0.0;
        std::size_t leg = 1;      ///< index of the waypoint the leg ends at; changes in the middle of a turn
        double course_rad = 0.0;  ///< of the track here
        double curvature_perM = 0.0;  ///< positive in a turn to starboard
    };
    /// The nearest point of the path not more than `behind_m` before and `ahead_m` after `from_m`.
    Place nearest(NorthEast p, double from_m, double behind_m, double ahead_m) const;
    /// The point of the path at a distance from its start, its course and curvature there.
    Place at(double along_m) const;
    NorthEast pointAt(double along_m) const;
    double length_m() const { return m_length_m; }
    /// Distance along the path at which a waypoint is passed (the middle of its arc).
    double alongOf(std::size_t waypoint) const { return m_alongOf[waypoint]; }

private:
    /// A straight (radius 0) or an arc.
    struct Piece {
        NorthEast start;
        double course_rad = 0.0;  ///< at its start
        double length_m = 0.0;
        double curvature_perM = 0.0;
        double from_m = 0.0;
    };
    Place placeOn(const Piece& piece, double within_m) const;

    std::vector<Piece> m_pieces;
    std::vector<double> m_alongOf;
    double m_length_m = 0.0;
};

}  // namespace sagara::core
