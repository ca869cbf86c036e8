#pragma once

#include "core/seakeeping/RadiationMemory.h"
#include "core/seakeeping/SeakeepingTables.h"

namespace sagara::core {

/// How a hull moves about a mean course: displacements of Bo from the point that goes along with the mean
/// speed, in frame B's axes on the mean heading, their rates, and what the water remembers. The same type
/// holds rates.
struct HullMotion {
    static constexpr std::size_t kValues = 12 + kMemoryValues;
    std::array<double, kValues> value{};

    double displacement(std::size_t i) const { return value[i]; }
    double velocity(std::size_t i) const { return value[6 + i]; }
    friend HullMotion operator+(HullMotion a, const HullMotion& b) {
        for (std::size_t i = 0; i < kValues; ++i) a.value[i] += b.value[i];
        return a;
    }
    friend HullMotion operator*(double s, HullMotion a) {
        for (double& v : a.value) v *= s;
        return a;
    }
};

/// A hull alone, without a manoeuvring model, at a fixed mean speed in six degrees of freedom: what strip
/// theory says in the frequency domain, in the time domain (Cummins 1962; Ogilvie 1964, 5th Symposium on
/// Naval Hydrodynamics). Small motions. With no rudder and no viscous forces in sway and yaw nothing holds
/// her course: for response in waves and decay, not for sailing.
class FloatingHull {
public:
    /// `transomTerms`: as the tables were made.
    explicit FloatingHull(const SeakeepingTables& tables, bool transomTerms = true);

    /// Under a force of N and N m besides those of weight and radiated waves.
    HullMotion rate(const HullMotion& motion, const Six& force, double speed_mps,
                    const ViscousRoll& roll) const;
    const RadiationMemory& memory() const { return m_memory; }

private:
    RadiationMemory m_memory;
    bool m_transomTerms;
    Matrix6 m_restoring;
    Matrix6 m_addedMass;   ///< at infinite frequency
    Matrix6 m_compliance;  ///< inverse of mass and added mass
};

/// Velocity of frame B through the water in frame B: a ship that goes ahead with her bow up rises, one that
/// is turned to starboard of her course slips to port.
Six relativeVelocity(const Six& displacement, const Six& rate, double speed_mps);

}  // namespace sagara::core
