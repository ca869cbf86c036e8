#include "core/vessel/Ballast.h"

#include <algorithm>
#include <cmath>

#include "core/vessel/Estimate.h"
#include "core/vessel/Metacentre.h"

namespace sagara::core {
namespace {

constexpr const char* kSource =
    "the loaded ship brought to ballast draught: displacement by Normand, derivatives by Clarke, Gedling & "
    "Hine 1983, resistance with the wetted surface of Denny & Mumford";

Hull ballastHull(const Hull& loaded) {
    Hull h = loaded;
    h.draught_m = std::clamp(2.0 + 0.02 * loaded.lengthBp_m, 0.55 * loaded.draught_m, 0.9 * loaded.draught_m);
    h.displacement_m3 =
        loaded.displacement_m3 *
        std::pow(h.draught_m / loaded.draught_m, loaded.waterplaneCoefficient / loaded.blockCoefficient());
    const double gravity_m = metacentre_m(loaded) - loaded.metacentricHeight_m;
    h.metacentricHeight_m = std::max(0.3, metacentre_m(h) - gravity_m);
    h.stations.clear();
    h.provenance = {Quality::Estimated, kSource};
    return h;
}

estimate::Form formOf(const Hull& h) {
    estimate::Form f{};
    f.length_m = h.lengthBp_m;
    f.beam_m = h.beam_m;
    f.draught_m = h.draught_m;
    f.volume_m3 = h.displacement_m3;
    f.block = h.blockCoefficient();
    return f;
}

double wettedSurface_m2(const Hull& h) {
    return 1.7 * h.lengthBp_m * h.draught_m + h.displacement_m3 / h.draught_m;
}

void bringTo(MmgParameters& p, const Hull& loaded, const Hull& ballast) {
    const estimate::Derivatives from = estimate::derivativesOf(formOf(loaded)),
                                to = estimate::derivativesOf(formOf(ballast));
    const double lighter = loaded.draught_m / ballast.draught_m;  // coefficients are over the draught
    const auto change = [&](double before, double after) { return lighter * after / before; };
    p.inertia.mx *= change(from.Xudot, to.Xudot);
    p.inertia.my *= change(from.Yvdot, to.Yvdot);
    p.inertia.Jz *= change(from.Nrdot, to.Nrdot);
    p.hull.Yv *= change(from.Yv, to.Yv);
    p.hull.Nv *= change(from.Nv, to.Nv);
    p.hull.Nr *= change(from.Nr, to.Nr);
    p.hull.R0 *= change(wettedSurface_m2(loaded), wettedSurface_m2(ballast));
}

}  // namespace

std::optional<Vessel> inBallast(const Vessel& loaded) {
    Vessel v = loaded;
    v.hull = ballastHull(loaded.hull);
    v.models.clear();
    for (NamedModel named : loaded.models) {
        auto* const mmg = std::get_if<MmgModel>(&named.parameters);
        if (!mmg) continue;
        bringTo(mmg->parameters, loaded.hull, v.hull);
        for (AsternSideRow& row : mmg->astern) {  // the same thrust over less draught
            row.Y *= loaded.hull.draught_m / v.hull.draught_m;
            row.N *= loaded.hull.draught_m / v.hull.draught_m;
        }
        named.provenance = {Quality::Estimated, kSource};
        v.models.push_back(std::move(named));
    }
    for (NamedModel& named : v.models)
        if (named.holds && !v.model(named.holds->elsewhere)) named.holds.reset();
    if (v.models.empty()) return std::nullopt;
    return v;
}

}  // namespace sagara::core
