#include "core/seakeeping/CompleteHull.h"

#include <algorithm>
#include <cmath>

#include "core/base/Config.h"
#include "core/base/Units.h"
#include "core/seakeeping/Hydrostatics.h"

namespace sagara::core {
namespace {

std::string number(double value) { return config::formatNumber(std::round(1e4 * value) / 1e4); }

void estimate(HullForm& form, double& value, double guess, const char* what, const char* unit) {
    if (value > 0.0) return;
    value = guess;
    form.notes.push_back(std::string(what) + " estimated: " + number(guess) + " " + unit);
}

void centreOfGravity(HullForm& form, const GivenOfHull& given, const Hydrostatics& floating) {
    if (given.gravityForward_m) {
        form.gravityForward_m = *given.gravityForward_m;
    } else {
        form.gravityForward_m = floating.buoyancyForward_m;
        form.notes.push_back("centre of gravity put over the centre of buoyancy, " +
                             number(form.gravityForward_m) + " m forward of midship");
    }
    const double metacentre_m = floating.buoyancyHeight_m + floating.transverseBM_m;
    if (given.gravityHeight_m) {
        form.gravityHeight_m = *given.gravityHeight_m;
    } else if (given.metacentricHeight_m) {
        form.gravityHeight_m = metacentre_m - *given.metacentricHeight_m;
        form.notes.push_back("centre of gravity " + number(form.gravityHeight_m) +
                             " m above the baseline, from the metacentric height");
    } else {
        form.gravityHeight_m = std::min(form.draught_m, metacentre_m - 0.05 * form.breadth_m);
        form.notes.push_back("centre of gravity estimated in the waterline or 0.05 B below the metacentre: " +
                             number(form.gravityHeight_m) + " m above the baseline");
    }
}

}  // namespace

void complete(HullForm& form, const GivenOfHull& given) {
    if (form.stations.empty() && given.form) {
        form.stations = stationsFrom(form.lengthBp_m, form.breadth_m, form.draught_m, *given.form);
        form.notes.push_back("stations made from the form coefficients");
    }
    const Hydrostatics floating = hydrostaticsOf(form.stations, form.draught_m);
    estimate(form, form.waterDensity_kgpm3, kSeaWaterDensity_kgpm3, "density of the water", "kg/m3");
    estimate(form, form.mass_kg, given.volume_m3.value_or(floating.volume_m3) * form.waterDensity_kgpm3,
             "mass", "kg");
    centreOfGravity(form, given, floating);
    estimate(form, form.rollGyradius_m, 0.37 * form.breadth_m, "radius of gyration in roll", "m");
    estimate(form, form.pitchGyradius_m, 0.25 * form.lengthBp_m, "radius of gyration in pitch", "m");
    estimate(form, form.yawGyradius_m, form.pitchGyradius_m, "radius of gyration in yaw", "m");
    form.freeboard_m = given.freeboard_m.value_or(0.0);
    estimate(form, form.freeboard_m, 0.5 * form.draught_m, "freeboard", "m");
}

}  // namespace sagara::core
