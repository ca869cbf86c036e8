#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "core/motion/MmgShip.h"
#include "core/motion/TransferShip.h"
#include "core/motion/WaveLoad.h"

namespace sagara::core {

/// One alternative for each kind of model. Each is made from its parameters and the vessel and has
/// acceleration, hullForces, forceFor, swayAddedMass_kg and ownsRoll.
using ManoeuvringShip = std::variant<PolynomialShip, TransferShip, MmgShip>;

/// One own ship's equations of motion, six degrees of freedom, worked out once from her vessel document.
/// Immutable. Surge, sway, yaw (and roll where it has it) belong to the manoeuvring model; heave, pitch (and
/// roll where it has not) are springs on the waterplane with added mass and damping. Where the chosen model
/// does not hold, another of the vessel takes over: both accelerations, in shares that change smoothly with
/// speed.
class ShipDynamics {
public:
    /// `model`: one the vessel has (Vessel::model tells); the first where the name is empty.
    ShipDynamics(const Vessel& vessel, const WaveTable& waves, std::string_view model = {});

    /// Rate of every field of the motion. `external`: all loads but those of hull, rudder, propellers and
    /// waves. `current`: of the water, in N, m/s. `depth_m`: from the surface to the ground below her.
    ShipMotion derivative(const ShipMotion& m, const Actuators& actuators, const Load& external,
                          const WaveEffect& waves, NorthEast current, double depth_m = kDeepWater_m) const;

    /// Forces of the water on hull, rudders, propellers and thrusters (counted with the propellers) alone, in
    /// the horizontal plane (other members 0). A model that has no force for something says what force would
    /// do the same.
    HullForces hullForces(const ShipMotion& m, const Actuators& actuators,
                          double depth_m = kDeepWater_m) const;
    /// The force in the horizontal plane, of all causes together, that changes her velocities at this rate:
    /// mass and added mass times acceleration, less what comes of the turning of frame B.
    Load forceFor(const ShipMotion& m, const ShipMotion& rate, double depth_m = kDeepWater_m) const;
    /// The force that would do what waves do in the horizontal plane, where they carry her along.
    Load horizontalForce(const WaveEffect& waves, double depth_m = kDeepWater_m) const;

    const WaveLoad& waveLoad() const { return m_waveLoad; }
    /// Mass that a blow from the side has to stop: ship and added mass in sway.
    double lateralMass_kg() const { return m_swayMass_kg; }
    double heaveStiffness_Npm() const { return m_c.heaveStiffness; }

private:
    static WaveLoad::Coefficients coefficients(const Vessel& vessel);

    /// 1 where the chosen model holds, 0 where the other has taken over.
    double shareOf(const ShipMotion& m, const Actuators& actuators) const;
    double rollOnSpring_radps2(const ShipMotion& m, double heel_Nm) const;
    PlanarAcceleration acceleration(const ShipMotion& m, const Actuators& actuators, const Load& load,
                                    double depth_m) const;

    ManoeuvringShip m_model;
    std::optional<HoldsIn> m_holds;
    std::optional<ManoeuvringShip> m_elsewhere;  ///< there with m_holds
    std::optional<HeightMotion> m_heightMotion;  ///< instead of springs on the waterplane
    std::size_t m_shafts;
    bool m_headingFollowsRoll;
    Thrusters m_thrusters;
    Hull m_hull;
    double m_mass_kg;
    double m_swayMass_kg;
    double m_pitchInertia_kgm2;
    double m_rollInertia_kgm2;  ///< with added inertia
    double m_rollDamping_Nms;
    WaveLoad::Coefficients m_c;
    WaveLoad m_waveLoad;
};

}  // namespace sagara::core
