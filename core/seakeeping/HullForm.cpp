#include "core/seakeeping/HullForm.h"

#include <algorithm>
#include <cmath>

#include "core/base/Units.h"
#include "core/seakeeping/CompleteHull.h"
#include "core/vessel/MidshipCoefficient.h"

namespace sagara::core {

double usualMidshipCoefficient(double blockCoefficient) {
    // The formula is one of cargo ships; fine hulls keep a prismatic coefficient of 0.56 or more.
    const double cargo = kerlenMidshipCoefficient(blockCoefficient);
    return std::clamp(std::min(cargo, blockCoefficient / 0.56), blockCoefficient, 0.995);
}

std::vector<HullStation> stationsFrom(double lengthBp_m, double breadth_m, double draught_m,
                                      FormCoefficients form) {
    constexpr int kStations = 31;
    const double prismatic = std::min(form.block / form.midship, 0.98);
    const double areaPower = prismatic / (1.0 - prismatic);
    const double waterplane = std::clamp(form.waterplane, prismatic * 0.8, 0.99);
    const double breadthPower = waterplane / (1.0 - waterplane);
    std::vector<HullStation> stations;
    for (int i = 0; i < kStations; ++i) {
        // The outermost a little inside, where the section is not yet a line.
        const double along = -std::cos(kPi * (i + 0.25) / (kStations - 0.5));
        const double breadth = breadth_m * (1.0 - std::pow(std::abs(along), breadthPower));
        const double area =
            breadth_m * draught_m * form.midship * (1.0 - std::pow(std::abs(along), areaPower));
        const double fullness = std::clamp(area / std::max(breadth * draught_m, 1e-9), 0.1, 0.999);
        const double depth_m = draught_m * (fullness < 0.5 ? fullness / (1.0 + fullness)
                                                           : 0.5 / fullness * (fullness / (2.0 - fullness)));
        stations.push_back({0.5 * lengthBp_m * along, breadth, draught_m, fullness * breadth * draught_m,
                            draught_m - depth_m});
    }
    return stations;
}

HullForm hullFormOf(const Hull& hull) {
    HullForm form;
    form.lengthBp_m = hull.lengthBp_m;
    form.breadth_m = hull.beam_m;
    form.draught_m = hull.draught_m;
    form.waterDensity_kgpm3 = hull.waterDensity_kgpm3;
    form.mass_kg = hull.mass_kg();
    form.rollGyradius_m = hull.rollGyradius_m;
    form.pitchGyradius_m = hull.pitchGyradius_m;
    form.yawGyradius_m = hull.pitchGyradius_m;
    form.stations = hull.stations;
    form.bilgeKeelLength_m = hull.bilgeKeelLength_m.value_or(0.25 * hull.lengthBp_m);
    form.bilgeKeelBreadth_m = hull.bilgeKeelBreadth_m.value_or(0.015 * hull.beam_m);
    if (!hull.bilgeKeelLength_m)
        form.notes.push_back("bilge keels of usual ships put on: 0.25 Lpp by 0.015 B");
    GivenOfHull given;
    given.freeboard_m = hull.depth_m - hull.draught_m;
    given.metacentricHeight_m = hull.metacentricHeight_m;
    given.form = FormCoefficients{hull.blockCoefficient(), usualMidshipCoefficient(hull.blockCoefficient()),
                                  hull.waterplaneCoefficient};
    complete(form, given);
    return form;
}

}  // namespace sagara::core
