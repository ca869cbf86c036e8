#include "core/motion/AsternSideForce.h"

namespace sagara::core {
namespace {

AsternSideRow at(const std::vector<AsternSideRow>& rows, double J) {
    if (J <= rows.front().J) return rows.front();
    std::size_t above = 1;
    while (above < rows.size() && rows[above].J < J) ++above;
    if (above == rows.size()) return rows.back();
    const AsternSideRow &a = rows[above - 1], &b = rows[above];
    const double share = (J - a.J) / (b.J - a.J);
    return {J, a.Y + share * (b.Y - a.Y), a.N + share * (b.N - a.N)};
}

}  // namespace

Load asternSideForce(const std::vector<AsternSideRow>& rows, const Hull& hull, const PropulsionUnit& unit,
                     const ScrewOrder& order, double surge_mps) {
    const double tip_mps = order.shaft_rps * order.pitch * unit.diameter_m;
    if (rows.empty() || tip_mps >= 0.0) return {};
    const AsternSideRow row = at(rows, surge_mps / tip_mps);
    const double scale_N =
        0.5 * hull.waterDensity_kgpm3 * hull.lengthBp_m * hull.draught_m * tip_mps * tip_mps;
    Load f = forceAt({}, -0.5 * hull.draught_m, {0.0, scale_N * row.Y});
    f.yaw_Nm = scale_N * hull.lengthBp_m * row.N;
    return f;
}

}  // namespace sagara::core
