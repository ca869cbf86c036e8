#pragma once

#include "core/vessel/Provenance.h"

namespace sagara::core {

struct Hull;

/// The bottom of a craft that planes, as a wedge of constant section: what Savitsky (1964) asks for.
struct PlaningHull {
    double chineBeam_m = 0.0;
    double deadrise_rad = 0.0;
    double gravityFromTransom_m = 0.0;  ///< centre of gravity forward of the transom, which is at -Lpp / 2
    Provenance provenance;
};
PlaningHull readPlaningHull(config::Reader& in);
/// What does not fit the hull it is the bottom of.
void checkPlaningHull(config::Reader& in, const PlaningHull& planing, const Hull& hull);

}  // namespace sagara::core
