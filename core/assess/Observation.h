#pragma once

#include <array>
#include <cstdint>

#include "core/base/Planar.h"
#include "core/base/SimTime.h"
#include "core/world/Anchor.h"
#include "core/world/Contact.h"

namespace sagara::core {

/// An anchor as an assessor on the bridge knows it.
struct AnchorObservation {
    bool down = false;   ///< let go and on the bottom
    NorthEast position;  ///< of the anchor
    double cableOut_m = 0.0;
    double dragged_m = 0.0;  ///< since it last came to the ground
    double dragSpeed_mps = 0.0;
};

inline constexpr double kObservedEvery_s = 0.2;

/// What is graded: one own ship at one moment, every kObservedEvery_s. Also what a recording keeps of her, so
/// that an old run can be graded again.
struct Observation {
    SimTime time;
    int level = 1;
    NorthEast position;
    double heading_rad = 0.0;
    NorthEast overGround_mps;         ///< velocity of midship as the GPS shows it, frame N
    double momentarySpeed_mps = 0.0;  ///< over the ground, with what the swell adds to and fro
    double alongGround_mps = 0.0;     ///< its part along the heading; negative: going astern
    double underKeel_m = 0.0;
    double clearOfShore_m = 0.0;  ///< hull to the nearest quay or shore, at most kShoreLimit_m
    double clearOfShips_m = 0.0;  ///< hull to the nearest hull that is not hostile, at most kShipsLimit_m
    double windFrom_rad = 0.0;    ///< mean wind
    std::uint8_t linesFast = 0;   ///< bit i: line i is on its bollard
    std::uint8_t linesOut = 0;    ///< bit i: line i is not yet aboard (a parted line is not out)
    std::array<AnchorObservation, kMostAnchors> anchors;
};
inline constexpr double kShoreLimit_m = 100.0;
inline constexpr double kShipsLimit_m = 5000.0;

/// Something that happened to the graded ship between two observations and matters at once.
struct Happening {
    enum class Kind : std::uint8_t { AnchorLetGo, Contact, Grounding, LineParted, CableParted };
    Kind kind = Kind::Contact;
    SimTime time;
    NorthEast place;  ///< of the anchor, the contact, the ship
    ContactKind contact = ContactKind::Fender;
    double speed_mps = 0.0;  ///< approach speed; at let go the speed along the heading over ground
    double energy_J = 0.0;
};

}  // namespace sagara::core
