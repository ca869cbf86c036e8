#pragma once

#include "core/seakeeping/RadiationMemory.h"
#include "core/seakeeping/WaveExcitation.h"
#include "core/seakeeping/WettedHull.h"

namespace sagara::core {

/// A vessel's hull ready for the time domain: her tables at work. Immutable; some 8 MB, so all ships of one
/// form and loading share one (`SeaHulls`). Frame B about Bo, order of the six as in `SeakeepingTables`.
struct SeaHull {
    /// `transomTerms`: as the tables were made.
    SeaHull(const HullForm& form, const SeakeepingTables& tables, bool transomTerms = true);

    bool transomTerms;
    Matrix6 mass;       ///< rigid body
    Matrix6 addedMass;  ///< at infinite frequency
    Matrix6 restoring;
    std::vector<double> speeds_mps;
    std::vector<ViscousRoll> viscousRoll;  ///< of each speed
    double rollFrequency_radps;            ///< natural, at rest
    RadiationMemory memory;
    WaveExcitation excitation;
    WettedHull wetted;

    ViscousRoll viscousRollAt(double speed_mps) const;
};

}  // namespace sagara::core
