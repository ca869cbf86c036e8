#pragma once

#include "core/motion/Actuators.h"
#include "core/motion/MmgRudderForce.h"
#include "core/motion/Planing.h"
#include "core/motion/PolynomialShip.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {

/// The MMG standard method at work, Yasukawa and Yoshimura (2015): exact with one screw and one rudder ahead;
/// extended to any number of both, each where it is, to four quadrants, to rest, to large drift and to
/// shallow water. Surge, sway and yaw about midship; the lateral velocity is that of the height of the centre
/// of gravity, so that roll does not enter the masses, and acts through the derivatives with phi. Of roll it
/// gives the heeling moment; inertia, damping and restoring are the ship's (see ShipDynamics).
class MmgShip {
public:
    MmgShip(const MmgModel& model, const Vessel& vessel);

    PlanarAcceleration acceleration(const ShipMotion& m, const Actuators& actuators, const Load& external,
                                    double depth_m = kDeepWater_m) const;
    HullForces hullForces(const ShipMotion& m, const Actuators& actuators,
                          double depth_m = kDeepWater_m) const;
    Load forceFor(const ShipMotion& m, const ShipMotion& rate,
                  double depth_m = kDeepWater_m) const;  ///< see ShipDynamics
    bool ownsRoll() const { return false; }
    double swayAddedMass_kg() const { return m_deep.inertia.my * m_massScale_kg; }

    /// Each screw and each rudder by itself, in the order of the vessel document.
    struct Parts {
        std::array<MmgPropeller, kMostShafts> screws;
        std::vector<MmgRudderForce> rudders;
    };
    Parts parts(const ShipMotion& m, const Actuators& actuators, double depth_m = kDeepWater_m) const;

private:
    /// The screw whose race a rudder is in, or else the nearest.
    struct Before {
        std::size_t screw;
        bool inRace;
    };
    using Screws = std::array<MmgPropeller, kMostShafts>;

    Screws screws(const MmgParameters& p, const ShipMotion& m, const Actuators& a, const MmgFlow& flow) const;
    static ScrewOrder orderOf(std::size_t screw, const Actuators& a);
    MmgRudderForce rudder(std::size_t i, const MmgParameters& p, const Screws& screws, const ShipMotion& m,
                          const Actuators& a, const MmgFlow& flow) const;
    HullForces forces(const MmgParameters& p, const ShipMotion& m, const Actuators& actuators) const;
    Load inertia(const MmgInertia& k, const ShipMotion& m, const ShipMotion& rate) const;

    MmgParameters m_deep;
    std::vector<AsternSideRow> m_astern;
    Hull m_hull;
    std::vector<Propeller> m_screws;
    Steering m_steering;
    std::vector<Before> m_before;  ///< of each rudder
    double m_massScale_kg;         ///< 1/2 rho L^2 d
    double m_mass_kg;
    double m_yawInertia_kgm2;  ///< about midship, without added
    double m_gravityDepth_m;   ///< of the centre of gravity, below the waterline
    std::optional<Planing> m_planing;
};

}  // namespace sagara::core
