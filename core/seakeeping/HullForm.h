#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Problems.h"
#include "core/base/Result.h"
#include "core/seakeeping/SectionPanels.h"
#include "core/vessel/Hull.h"

namespace sagara::core {

/// A hull and how it is loaded: what hydrostatics and strip theory start from. SI; stations as in a vessel's
/// document (x forward of midship, centroids above the baseline, from aft forward).
struct HullForm {
    std::string name;
    double lengthBp_m = 0.0;
    double breadth_m = 0.0;
    double draught_m = 0.0;    ///< baseline below the waterline
    double freeboard_m = 0.0;  ///< deck above the waterline, for the GZ curve
    double waterDensity_kgpm3 = 0.0;
    double mass_kg = 0.0;
    double gravityForward_m = 0.0;  ///< of midship
    double gravityHeight_m = 0.0;   ///< above the baseline
    double rollGyradius_m = 0.0;    ///< this and the next two about the centre of gravity
    double pitchGyradius_m = 0.0;
    double yawGyradius_m = 0.0;
    double addedRollDamping_Nms = 0.0;  ///< linear, beside what the hull makes
    double bilgeKeelLength_m = 0.0;     ///< nothing: none
    double bilgeKeelBreadth_m = 0.0;
    std::vector<HullStation> stations;
    /// Half sections from the keel to the waterline, z up from it, one for each station; empty where the
    /// stations are all that is known.
    std::vector<std::vector<SectionPoint>> offsets;
    std::vector<std::string> notes;  ///< what was estimated, and how
};

/// Reads the schema of reference/seakeeping/*_hull.json: `length_pp_m`, `breadth_m`, `draught_m`, `stations`
/// and, given or null, the rest; what is null is estimated. In place of `stations` it takes `waterlines_m`
/// (heights above the baseline) with `offsets` (rows [x_m, half breadth on each of them]), or no more than
/// the form coefficients `Cb`, `Cm`, `Cw`. Members it does not know are let be. All problems at once.
Result<HullForm, config::Problems> readHullForm(const std::string& name, std::string_view json);

/// The hull of a vessel's document. Its metacentric height and gyradii hold; what it has not is estimated.
HullForm hullFormOf(const Hull& hull);

/// Coefficients of a hull that has no stations.
struct FormCoefficients {
    double block = 0.0;
    double midship = 0.0;
    double waterplane = 0.0;
};
/// Sectional areas and waterline breadths that fall from midship by a power each, 31 stations, even keel, the
/// same fore and aft: good for seakeeping of usual forms, not for trim.
std::vector<HullStation> stationsFrom(double lengthBp_m, double breadth_m, double draught_m,
                                      FormCoefficients form);
/// Midship section coefficient of usual hulls: Kerlen (1970), in Papanikolaou (2014), Ship Design, 2.10.
double usualMidshipCoefficient(double blockCoefficient);

}  // namespace sagara::core
