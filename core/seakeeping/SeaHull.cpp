#include "core/seakeeping/SeaHull.h"

#include <algorithm>

namespace sagara::core {

SeaHull::SeaHull(const HullForm& form, const SeakeepingTables& tables, bool transom)
    : transomTerms(transom),
      mass(tables.mass),
      addedMass(tables.addedMassInfinite),
      restoring(tables.restoring),
      speeds_mps(tables.speeds_mps),
      viscousRoll(tables.viscousRoll),
      rollFrequency_radps(tables.rollFrequency_radps),
      memory(tables),
      excitation(tables),
      wetted(form) {}

ViscousRoll SeaHull::viscousRollAt(double speed_mps) const {
    std::size_t low = 0;
    while (low + 2 < speeds_mps.size() && speeds_mps[low + 1] <= speed_mps) ++low;
    if (low + 1 >= speeds_mps.size()) return viscousRoll.front();
    const double share =
        std::clamp((speed_mps - speeds_mps[low]) / (speeds_mps[low + 1] - speeds_mps[low]), 0.0, 1.0);
    const ViscousRoll &a = viscousRoll[low], &b = viscousRoll[low + 1];
    return {a.linear_Nms + share * (b.linear_Nms - a.linear_Nms),
            a.quadratic_Nms2 + share * (b.quadratic_Nms2 - a.quadratic_Nms2)};
}

}  // namespace sagara::core
