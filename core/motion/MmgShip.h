#pragma once

#include "core/motion/Actuators.h"
#include "core/motion/MmgRudderForce.h"
#include "core/motion/PolynomialShip.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {

/// The MMG standard method at work, Yasukawa and Yoshimura (2015): exact with one screw and one rudder ahead;
/// extended to any number of both, each where it is, to four quadrants, to rest and to large drift. Surge,
/// sway and yaw about midship; the lateral velocity is that of the height of the centre of gravity, so that
/// roll does not enter the masses, and acts through the derivatives with phi. Of roll it gives the heeling
/// moment; inertia, damping and restoring are the ship's (see ShipDynamics).
class MmgShip {
public:
    MmgShip(const MmgModel& model, const Vessel& vessel);

    PlanarAcceleration acceleration(const ShipMotion& m, const Actuators& actuators,
                                    const Load& external) const;
    HullForces hullForces(const ShipMotion& m, const Actuators& actuators) const;
    Load forceFor(const ShipMotion& m, const ShipMotion& rate) const;  ///< see ShipDynamics
    double swayAddedMass_kg() const { return m_model.inertia.my * m_massScale_kg; }

    /// Each screw and each rudder by itself, in the order of the vessel document.
    MmgPropeller propeller(std::size_t i, const ShipMotion& m, const Actuators& actuators) const;
    MmgRudderForce rudder(std::size_t i, const ShipMotion& m, const Actuators& actuators) const;

private:
    /// The screw whose race a rudder is in, or else the nearest.
    struct Before {
        std::size_t screw;
        bool inRace;
    };

    MmgModel m_model;
    Hull m_hull;
    Propulsion m_propulsion;
    Steering m_steering;
    std::vector<Before> m_before;  ///< of each rudder
    double m_massScale_kg;         ///< 1/2 rho L^2 d
    double m_mass_kg;
    double m_yawInertia_kgm2;  ///< about midship, without added
};

}  // namespace sagara::core
