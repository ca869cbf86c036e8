#pragma once

#include <array>
#include <memory>

#include "core/motion/Load.h"
#include "core/motion/MovingShip.h"
#include "core/motion/PolynomialShip.h"
#include "core/seakeeping/SeaHull.h"

namespace sagara::core {

/// One ship's six motions in waves, a manoeuvring model and the tables of her hull in one frame (a unified
/// theory after Bailey, Price and Temarel 1997, Trans. RINA 140, and Fossen 2005, Modeling Identification and
/// Control 26, 189-203), each counted once:
///
/// - surge, sway and yaw (and roll where the model has it) belong to the model for slow motions. It says at
///   which rate a she would change her velocity if the water remembered nothing; the tables make a force of
///   it by their own inertia for slow motions, M + A(0). So where nothing goes to and fro she does exactly
///   what the model says, whatever the tables hold.
/// - The tables add the waves' force and what radiated waves remember beyond A(0), the same of the moment of
///   a hull that drifts at speed.
/// - Heave, pitch (and roll where the model has it not) are the tables': restoring, radiation, viscous roll
///   damping. Roll feels the heeling moment of the model's forces and the turning of the ship.
/// - A model that owns roll keeps its period and its damping and rolls against the waves' effective slope
///   (`effectiveHeel_rad`): the tables give that slope and keep no memory of roll.
class SeaMotion {
public:
    /// `rollDamping`: in place of that of the tables.
    SeaMotion(std::shared_ptr<const SeaHull> hull, bool ownsRoll,
              const std::optional<ViscousRoll>& rollDamping);

    struct Rate {
        Six acceleration{};  ///< of the six velocities of ShipMotion
        MemoryState water{};
    };
    /// `model`: of the manoeuvring model under all loads but first-order waves. `external`: loads on heave,
    /// roll and pitch. `waves`: at the ship's place.
    Rate rate(const MovingShip& ship, const PlanarAcceleration& model, const Load& external,
              const WaveForces& waves) const;

    /// The loads on heave and pitch that hold her at an attitude of her own on even water.
    Load holding(double down_m, double pitch_rad, double surge_mps) const;

    /// The heel at which calm water would give her the waves' roll moment, less what they make by swaying
    /// her; for a model that owns roll, else 0. In a long wave the slope of its surface.
    double effectiveHeel_rad(const WaveForces& waves) const;

    const SeaHull& hull() const { return *m_hull; }

private:
    using Three = std::array<double, 3>;
    using Square = std::array<Three, 3>;
    /// What radiated waves do at this instant.
    struct Water {
        Six velocity{};  ///< of frame B through it, as it remembers
        Six kept{};      ///< rate of the momentum it remembers
        Six momentum{};
        Six end{};  ///< momentum of the aftmost section, per unit length
    };
    /// What acts on the ship.
    struct Acting {
        const PlanarAcceleration& model;
        const Load& external;
        const WaveForces& waves;
    };
    double ahead(double surge_mps) const;  ///< speed that strip theory is asked at
    Six velocity(const ShipMotion& m) const;
    double roll_Nm(const ShipMotion& m, const Acting& acting) const;
    Three lateral(const ShipMotion& m, const Water& water, const Acting& acting) const;
    Three vertical(const ShipMotion& m, const Water& water, const Acting& acting) const;

    std::shared_ptr<const SeaHull> m_hull;
    bool m_ownsRoll;
    std::optional<ViscousRoll> m_rollDamping;  ///< of her document; else that of the tables
    Matrix6 m_slow;                            ///< mass with added mass for slow motions
    double m_fastest_mps;
    Square m_lateral;                              ///< inverse of what sway, roll and yaw set in motion
    double m_swayInRoll = 0.0, m_yawInRoll = 0.0;  ///< moment of a swaying, yawing ship over the force
    Square m_vertical;                             ///< of surge, heave, pitch
};

}  // namespace sagara::core
