#pragma once

#include <cstdint>

#include "core/vessel/Provenance.h"

namespace sagara::core {

/// Published formulas for the largest sinkage under way; see core/motion/Squat.h.
enum class SquatFormula : std::uint8_t { BarrassSimple, Barrass, Icorels, Yoshimura };

/// What a vessel feels of the ground, the banks and other ships. What her manoeuvring model has of its own is
/// not added again. Without the group in the document: squat alone, by Barrass's simple form.
struct ShallowWater {
    SquatFormula squat = SquatFormula::BarrassSimple;
    bool hull = false;   ///< forces of the hull grow as the water gets shallow
    bool bank = false;   ///< suction and cushion
    bool ships = false;  ///< interaction with ships that pass
    Provenance provenance;
};
/// "squat": barrass-simple, barrass, icorels or yoshimura; "hull": kijima or none; "bank": norrbin or none;
/// "ships": slender-body or none.
ShallowWater readShallowWater(config::Reader& in);

}  // namespace sagara::core
