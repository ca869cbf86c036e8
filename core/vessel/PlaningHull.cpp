#include "core/vessel/PlaningHull.h"

#include <cmath>

#include "core/base/Units.h"
#include "core/vessel/Hull.h"

namespace sagara::core {

PlaningHull readPlaningHull(config::Reader& in) {
    PlaningHull p;
    p.chineBeam_m = in.number("chineBeam_m", {0.3, 12.0, "m"});
    p.deadrise_rad = kDegree_rad * in.number("deadrise_deg", {5.0, 35.0, "deg"});
    p.gravityFromTransom_m = in.number("gravityFromTransom_m", {0.5, 25.0, "m"});
    p.provenance = readProvenance(in);
    in.rejectUnknownKeys();
    return p;
}

void checkPlaningHull(config::Reader& in, const PlaningHull& planing, const Hull& hull) {
    if (planing.chineBeam_m > hull.beam_m)
        in.problem("planing.chineBeam_m", "is " + config::formatNumber(planing.chineBeam_m),
                   "at most the beam, " + config::formatNumber(hull.beam_m) + " m");
    const auto tidy = [](double value_m) { return std::round(100.0 * value_m) / 100.0; };
    const double least_m = tidy(0.2 * hull.lengthBp_m), most_m = tidy(0.6 * hull.lengthBp_m);
    if (planing.gravityFromTransom_m < least_m || planing.gravityFromTransom_m > most_m)
        in.problem("planing.gravityFromTransom_m", "is " + config::formatNumber(planing.gravityFromTransom_m),
                   config::formatNumber(least_m) + " to " + config::formatNumber(most_m) +
                       " m, 0.2 to 0.6 of lengthBp_m");
}

}  // namespace sagara::core
