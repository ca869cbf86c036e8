#pragma once

#include "core/seakeeping/HullForm.h"
#include "core/seakeeping/RollDamping.h"
#include "core/seakeeping/SeakeepingTables.h"

namespace sagara::core {

struct TableOptions {
    double greatestFroude = 0.4;          ///< of the speeds, which go up in steps of 0.1 sqrt(g Lpp)
    bool transomTerms = true;             ///< the terms of the aftmost section at speed
    std::vector<double> speeds_mps = {};  ///< where given, these and no steps
};

/// Key of the cache: the same for the same hull, loading and options, and only then.
std::uint64_t tablesHash(const HullForm& form, const TableOptions& options);

/// A second or two of work: made once per vessel and loading and kept.
SeakeepingTables makeTables(const HullForm& form, const TableOptions& options = {});

/// What Ikeda's method wants to know of the hull.
IkedaShip ikedaShipOf(const HullForm& form);

/// Straight line through Ikeda's equivalent damping over the amplitude, least squares over 2 to 20 degrees,
/// and what the hull's description adds.
ViscousRoll viscousRollAt(const HullForm& form, double omega_radps, double speed_mps);

}  // namespace sagara::core
