#pragma once

#include <limits>

#include "core/base/Planar.h"

namespace sagara::core {

/// A depth that no model feels.
inline constexpr double kDeepWater_m = std::numeric_limits<double>::infinity();

/// Where an own ship is and how she moves: six degrees of freedom of Bo. Velocities are through the water, in
/// B. The same type holds the rates of all fields, so that an integrator needs only + and *.
struct ShipMotion {
    double north_m = 0.0;
    double east_m = 0.0;
    double down_m = 0.0;       ///< heave, positive downward from the still-water floating position
    double roll_rad = 0.0;     ///< starboard side down is positive
    double pitch_rad = 0.0;    ///< bow up is positive
    double heading_rad = 0.0;  ///< of Bx in frame N, not wrapped
    double surge_mps = 0.0;
    double sway_mps = 0.0;
    double heaveRate_mps = 0.0;
    double rollRate_radps = 0.0;
    double pitchRate_radps = 0.0;
    double yawRate_radps = 0.0;

    NorthEast position() const { return {north_m, east_m}; }

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.north_m, self.east_m, self.down_m, self.roll_rad, self.pitch_rad, self.heading_rad,
           self.surge_mps, self.sway_mps, self.heaveRate_mps, self.rollRate_radps, self.pitchRate_radps,
           self.yawRate_radps);
    }
};

inline ShipMotion operator+(const ShipMotion& a, const ShipMotion& b) {
    return {a.north_m + b.north_m,
            a.east_m + b.east_m,
            a.down_m + b.down_m,
            a.roll_rad + b.roll_rad,
            a.pitch_rad + b.pitch_rad,
            a.heading_rad + b.heading_rad,
            a.surge_mps + b.surge_mps,
            a.sway_mps + b.sway_mps,
            a.heaveRate_mps + b.heaveRate_mps,
            a.rollRate_radps + b.rollRate_radps,
            a.pitchRate_radps + b.pitchRate_radps,
            a.yawRate_radps + b.yawRate_radps};
}
inline ShipMotion operator*(double s, const ShipMotion& a) {
    return {s * a.north_m,       s * a.east_m,         s * a.down_m,          s * a.roll_rad,
            s * a.pitch_rad,     s * a.heading_rad,    s * a.surge_mps,       s * a.sway_mps,
            s * a.heaveRate_mps, s * a.rollRate_radps, s * a.pitchRate_radps, s * a.yawRate_radps};
}

/// Velocity through the water of a point of the ship, in B.
inline BodyPoint velocityAt(const ShipMotion& m, BodyPoint p) {
    return {m.surge_mps - m.yawRate_radps * p.y_m, m.sway_mps + m.yawRate_radps * p.x_m};
}

}  // namespace sagara::core
