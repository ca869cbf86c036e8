#pragma once

#include <QFlags>
#include <QString>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/Planar.h"
#include "core/exercise/ForceCause.h"
#include "core/world/Area.h"
#include "core/world/Route.h"

/// What a chart shows over the area: plain values in SI and frame N, given by whoever owns the widget.
namespace sagara::ui {

/// What can be switched on and off.
enum class ChartLayer : unsigned {
    Contours = 1u << 0,
    Soundings = 1u << 1,
    Marks = 1u << 2,
    Lights = 1u << 3,  ///< flares and characters
    Berths = 1u << 4,
    Places = 1u << 5,
    Graticule = 1u << 6,
    OwnShips = 1u << 7,
    Targets = 1u << 8,
    Names = 1u << 9,  ///< of ships
    Vectors = 1u << 10,
    Track = 1u << 11,
    Prediction = 1u << 12,
    Route = 1u << 13,
    Zones = 1u << 14,
    Anchors = 1u << 15,
    SafetyLimits = 1u << 16,
    Forces = 1u << 17
};
Q_DECLARE_FLAGS(ChartLayers, ChartLayer)
inline constexpr ChartLayers kAllChartLayers = ChartLayers::fromInt(0x3ffffu);

struct ChartShip {
    int id = 0;
    QString name;
    core::NorthEast position;  ///< midship
    double heading_rad = 0.0;
    core::NorthEast overGround_mps;
    double length_m = 0.0;
    double beam_m = 0.0;
    bool hostile = false;
};

struct ChartTrackPoint {
    double time_s = 0.0;  ///< of the exercise
    core::NorthEast position;
};

/// Where a ship has been, in the order of time.
struct ChartTrack {
    std::vector<ChartTrackPoint> points;
    bool ownShip = true;
};

struct ChartPose {
    double time_s = 0.0;
    core::NorthEast position;
    double heading_rad = 0.0;
};

/// Where a ship will be; the first pose is now.
struct ChartPrediction {
    std::vector<ChartPose> poses;
    double length_m = 0.0;
    double beam_m = 0.0;
};

/// A circle (no corners), a gate (two corners) or a polygon (three and more).
struct ChartZone {
    enum class Kind { Task, Done, Limit };
    int id = 0;
    QString name;
    Kind kind = Kind::Task;
    core::NorthEast centre;
    double radius_m = 0.0;
    std::vector<core::NorthEast> corners;
};

struct ChartAnchor {
    QString name;              ///< "port anchor, 4.1 shackles"
    core::NorthEast position;  ///< on the ground
    double swing_m = 0.0;      ///< radius the ship's stern can reach; 0: not drawn
};

/// Something that can be dragged: a waypoint, a target, the centre or a corner of a zone.
struct ChartHandle {
    int id = 0;
    core::NorthEast position;
    QString hint;       ///< for its tooltip
    bool open = false;  ///< drawn round what it moves, which stays to be seen
};

/// One cause that pushes the own ship, in frame B: where it pushes and how hard.
struct ShownForce {
    core::ForceCause cause = core::ForceCause::Hull;
    core::BodyPoint at;
    core::BodyPoint force_N;
    double size_N() const { return std::hypot(force_N.x_m, force_N.y_m); }
};

struct ChartScene {
    std::vector<ChartShip> ownShips;  ///< the first is followed and measured from
    std::vector<ChartShip> targets;
    std::vector<ChartTrack> tracks;
    std::vector<ChartPrediction> predictions;
    core::Route route;
    core::RoutePath path;  ///< of the route
    std::vector<ChartZone> zones;
    std::vector<ChartAnchor> anchors;
    std::vector<core::Mark> marks;  ///< beside those of the area: of a scenario that is being made
    std::string ialaRegion;         ///< "A" or "B": the colours of its marks
    std::vector<ChartHandle> handles;
    std::vector<ShownForce> forces;  ///< on the first own ship
    double forceScale_NPerPx = 0.0;  ///< 0: as suits the forces
    double clearance_m = 0.0;        ///< to be kept from other ships: a ring about the own ship; 0: none
    double vector_min = 6.0;         ///< length of speed vectors
    double clockAtZero_s = 0.0;      ///< time of day at time 0, for the times along tracks
};

}  // namespace sagara::ui

Q_DECLARE_OPERATORS_FOR_FLAGS(sagara::ui::ChartLayers)
