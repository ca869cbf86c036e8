#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <variant>

#include "core/motion/MmgShip.h"
#include "core/motion/Planing.h"
#include "core/motion/SeaMotion.h"
#include "core/motion/TransferShip.h"
#include "core/motion/WaveEffect.h"

namespace sagara::core {

/// One alternative for each kind of model. Each is made from its parameters and the vessel and has
/// acceleration, hullForces, forceFor, swayAddedMass_kg and ownsRoll.
using ManoeuvringShip = std::variant<PolynomialShip, TransferShip, MmgShip>;

/// One own ship's equations of motion, six degrees of freedom, worked out once from her vessel document and
/// her hull. Immutable. Surge, sway, yaw (and roll where it has it) belong to the manoeuvring model, the rest
/// and what waves do to the hull's tables (SeaMotion). Where the chosen model does not hold, another of the
/// vessel takes over: both accelerations, in shares that change smoothly with speed.
class ShipDynamics {
public:
    /// `model`: one the vessel has (Vessel::model tells); the first where the name is empty. Without a hull
    /// she sails in calm water only: heave, pitch (and roll where the model has it not) are springs on the
    /// waterplane with the added mass and damping of her document, enough for trials.
    explicit ShipDynamics(const Vessel& vessel, std::string_view model = {},
                          std::shared_ptr<const SeaHull> hull = nullptr);

    /// Rate of every field of the motion in calm water, on springs. `external`: all loads but those of hull,
    /// rudder and propellers. `current`: of the water, in N, m/s. `depth_m`: from the surface to the ground
    /// below her.
    ShipMotion derivative(const ShipMotion& m, const Actuators& actuators, const Load& external,
                          NorthEast current, double depth_m = kDeepWater_m) const;
    /// The same in waves, of the water's memory too.
    MovingShip derivative(const MovingShip& ship, const Actuators& actuators, const Load& external,
                          const WaveEffect& waves, NorthEast current, double depth_m = kDeepWater_m) const;
    /// What the active components do to her as she lies and moves. `shelter`: factor on their heights.
    WaveEffect wavesAt(const ActiveWaves& waves, const ShipMotion& m, double shelter) const;

    /// Her motion through the water that goes to and fro and slopes in the waves: what her manoeuvring model
    /// is asked with. Without a hull for the sea: as she moves.
    ShipMotion throughWater(const ShipMotion& m, const WaveForces& waves) const;

    /// Forces of the water on hull, rudders, propellers and thrusters (counted with the propellers) alone, in
    /// the horizontal plane (other members 0). A model that has no force for something says what force would
    /// do the same.
    HullForces hullForces(const ShipMotion& m, const Actuators& actuators,
                          double depth_m = kDeepWater_m) const;
    /// The force in the horizontal plane, of all causes together, that changes her velocities at this rate:
    /// mass and added mass times acceleration, less what comes of the turning of frame B.
    Load forceFor(const ShipMotion& m, const ShipMotion& rate, double depth_m = kDeepWater_m) const;

    /// Whether the chosen model has roll of its own.
    bool ownsRoll() const;
    /// Whether the sea moves her: a hull, and a model that feels it.
    bool feelsWaves() const { return m_sea.has_value(); }

    /// Mass that a blow from the side has to stop: ship and added mass in sway.
    double lateralMass_kg() const { return m_swayMass_kg; }
    double length_m() const { return m_hull.lengthBp_m; }
    double heaveStiffness_Npm() const { return m_springs.heaveStiffness; }

private:
    /// On the waterplane, for calm water.
    struct Springs {
        explicit Springs(const Vessel& vessel);
        double heaveMass, heaveStiffness, heaveDamping;
        double pitchInertia, pitchStiffness, pitchDamping;
        double rollInertia, rollStiffness, rollDamping;
    };
    void takeToSea(const Vessel& vessel, std::shared_ptr<const SeaHull> hull);
    /// 1 where the chosen model holds, 0 where the other has taken over.
    double shareOf(const ShipMotion& m, const Actuators& actuators) const;
    PlanarAcceleration acceleration(const ShipMotion& m, const Actuators& actuators, const Load& load,
                                    double depth_m) const;
    ShipMotion kinematics(const ShipMotion& m, NorthEast current) const;
    ShipMotion onSprings(const ShipMotion& m, const Actuators& actuators, const Load& external,
                         const WaveHeights& heights, NorthEast current, double depth_m) const;

    ManoeuvringShip m_model;
    std::optional<HoldsIn> m_holds;
    std::optional<ManoeuvringShip> m_elsewhere;  ///< there with m_holds
    std::optional<HeightMotion> m_heightMotion;  ///< instead of tables and springs
    std::optional<SeaMotion> m_sea;
    std::optional<Planing> m_planing;
    std::size_t m_shafts;
    bool m_headingFollowsRoll;
    bool m_instantaneousHull;
    Thrusters m_thrusters;
    Hull m_hull;
    Waterplane m_waterplane;
    double m_mass_kg;
    double m_swayMass_kg;
    double m_gravityDepth_m;
    Springs m_springs;
};

}  // namespace sagara::core
