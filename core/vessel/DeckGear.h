#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/Planar.h"
#include "core/vessel/Provenance.h"

namespace sagara::core {

inline constexpr std::size_t kMostLines = 8;  ///< of one ship in an exercise
inline constexpr std::size_t kMostAnchors = 2;

/// Where a mooring line leaves the ship.
struct Fairlead {
    std::string id;
    BodyPoint position;
};

/// Lines and the winches that work them; all lines are alike.
struct MooringGear {
    std::vector<Fairlead> fairleads;
    double breakingLoad_N = 0.0;
    double stiffness_N = 0.0;     ///< EA: tension per strain
    double winchPull_N = 0.0;     ///< heaving stops there
    double winchSpeed_mps = 0.0;  ///< of heaving, slacking and hauling in
    Provenance provenance;

    const Fairlead* find(const std::string& id) const;
};
MooringGear readMooringGear(config::Reader& in);

/// One anchor, its cable and windlass.
struct AnchorGear {
    std::string id;
    BodyPoint hawse;
    double hawseHeight_m = 0.0;  ///< above the waterline
    double anchorMass_kg = 0.0;
    double holdingFactor = 0.0;  ///< holding power over weight in good ground
    double cableLength_m = 0.0;
    double cableMass_kgpm = 0.0;
    double breakingLoad_N = 0.0;
    double heaveSpeed_mps = 0.0;  ///< of the windlass, heaving in and walking out
};
struct GroundTackle {
    std::vector<AnchorGear> anchors;
    Provenance provenance;
};
GroundTackle readGroundTackle(config::Reader& in);

}  // namespace sagara::core
