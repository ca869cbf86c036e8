#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/motion/Load.h"
#include "core/motion/ShipMotion.h"
#include "core/vessel/Hull.h"
#include "core/world/Area.h"

namespace sagara::core {

/// What a ship can touch at the waterline.
enum class ContactKind : std::uint8_t { Fender, Quay, Breakwater, Shore, Ship };
inline constexpr std::size_t kContactKinds = 5;
const char* contactKindName(ContactKind kind);

/// The part of an own ship that touches. Immutable.
struct ContactHull {
    std::vector<BodyPoint> outline;
    double radius_m = 0.0;  ///< of the circle about midship that holds the outline
    BodyPoint halfSize;     ///< of the box that holds it
    double length_m = 0.0;
    double mass_kg = 0.0;         ///< of the ship alone: what a blow from ahead has to stop
    double lateralMass_kg = 0.0;  ///< with the added mass of sway
};
ContactHull contactHull(const Hull& hull, double lateralMass_kg);

/// Another ship as an obstacle for one tick: her outline, where it lies and how it moves over the ground.
struct ShipObstacle {
    std::span<const BodyPoint> outline;
    BodyPoint halfSize;  ///< of the box that holds the outline
    NorthEast position;
    double heading_rad = 0.0;
    NorthEast velocity;
    double mass_kg = 0.0;
    std::int32_t index = 0;  ///< targets count from 0, other own ships from -1 down
};

/// Everything near enough to one ship to be touched in this tick. Fixed size, on the stack; made once a tick.
struct Obstacles {
    struct NearShore {
        std::uint32_t vertex;  ///< of the outline
        const Shore::Piece* piece;
        ContactKind kind;
    };
    struct NearCorner {
        const Shore::Piece* piece;  ///< its first point
        ContactKind kind;
    };
    struct NearFender {
        const Fender* fender;
        NorthEast outward;
    };
    template <typename T, std::size_t N>
    struct List {
        std::array<T, N> items;
        std::size_t count = 0;
        void add(const T& item) {
            if (count < N) items[count++] = item;
        }
        const T* begin() const { return items.data(); }
        const T* end() const { return items.data() + count; }
    };
    List<NearShore, 128> shore;
    List<NearCorner, 64> corners;
    List<NearFender, 64> fenders;
    List<ShipObstacle, 8> ships;

    bool empty() const { return shore.count + corners.count + fenders.count + ships.count == 0; }
};

/// Shore and fenders in reach; ships are added by the caller.
void findObstacles(const Area& area, const ContactHull& hull, const ShipMotion& m, Obstacles& found);

/// Elastic, damped contact with dry friction at every point where outlines overlap. Stiffness follows the
/// ship's mass (natural frequency of the blow 6 rad/s), so that the fixed tick serves ships of every size; a
/// fender has its own.
Load contactLoad(const Obstacles& obstacles, const ContactHull& hull, const ShipMotion& m, NorthEast current);

/// The hardest point of contact of each kind, for events.
struct Touch {
    bool touching = false;
    NorthEast place;
    double approach_mps = 0.0;  ///< relative speed into the obstacle, along the normal; negative when parting
    double energy_J = 0.0;      ///< of the blow: half the mass that is stopped times its speed squared
    std::int32_t other = 0;     ///< for ships: ShipObstacle::index
};
using Touches = std::array<Touch, kContactKinds>;
Touches findTouches(const Obstacles& obstacles, const ContactHull& hull, const ShipMotion& m,
                    NorthEast current);

}  // namespace sagara::core
