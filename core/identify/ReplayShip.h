#pragma once

#include <optional>

#include "core/identify/SeaTrial.h"
#include "core/motion/Propeller.h"
#include "core/motion/ShipDynamics.h"

namespace sagara::core {

/// A vessel whose rudder and shafts are where a record says, for comparing her with the record. Without
/// steering gear and engines: for trials with these see TrialShip.
class ReplayShip {
public:
    /// `model`: see ShipDynamics.
    ReplayShip(const Vessel& vessel, std::string_view model, double depth_m);

    ShipMotion motion;  ///< calm water

    void step(double rudder_rad, double shaft_rps, double step_s);
    ShipMotion rate(const ShipMotion& m, double rudder_rad, double shaft_rps) const;

    /// The shaft speed at which she neither gains nor loses speed straight ahead. Where the model's thrust
    /// does not depend on it: full ahead.
    double holdingShaft_rps(double speed_mps) const;
    /// Steady straight ahead at a shaft speed; none: never, up to 60 m/s.
    std::optional<double> steadySpeed_mps(double shaft_rps) const;
    /// The rudder angle at which she turns steadily at this rate, from a first guess of it and of the speed
    /// with this shaft; none: nowhere.
    std::optional<double> steadyRudder_rad(double yawRate_radps, double shaft_rps, double speed_mps,
                                           double guess_rad) const;

    const Vessel& vessel() const { return m_vessel; }
    const ShipDynamics& dynamics() const { return m_dynamics; }
    Actuators actuators(double rudder_rad, double shaft_rps) const;

private:
    Vessel m_vessel;
    ShipDynamics m_dynamics;
    double m_depth_m;
};

}  // namespace sagara::core
