#pragma once

#include <optional>
#include <vector>

#include "core/base/Planar.h"
#include "core/vessel/Provenance.h"
#include "core/vessel/Stations.h"

namespace sagara::core {

/// Main particulars and form of the hull at the loading described. Frame B, SI.
struct Hull {
    double lengthOverall_m = 0.0;
    double lengthBp_m = 0.0;
    double beam_m = 0.0;
    double draught_m = 0.0;
    double depth_m = 0.0;  ///< keel to main deck
    double displacement_m3 = 0.0;
    double waterDensity_kgpm3 = 0.0;   ///< of the water the numbers hold in
    double metacentricHeight_m = 0.0;  ///< transverse GM
    double waterplaneCoefficient = 0.0;
    double rollGyradius_m = 0.0;
    double pitchGyradius_m = 0.0;              ///< also used in yaw where a model has no inertia of its own
    std::optional<double> bilgeKeelLength_m;   ///< of one side; 0: she has none; not given: not known
    std::optional<double> bilgeKeelBreadth_m;  ///< out from the hull
    std::vector<HullStation> stations;         ///< none: the form is worked out from the particulars
    Provenance provenance;

    double mass_kg() const { return displacement_m3 * waterDensity_kgpm3; }
    double blockCoefficient() const { return displacement_m3 / (lengthBp_m * beam_m * draught_m); }
    double waterplaneArea_m2() const { return waterplaneCoefficient * lengthBp_m * beam_m; }
};

/// Outline of the ship at the waterline and above, as seen from above: what touches a quay. Clockwise from
/// the bow, points at most `kOutlineStep_m` apart. A pointed bow over the forward 30 % of the length,
/// parallel sides, a transom at 85 % of the beam: enough for contact; the picture has its own hull.
std::vector<BodyPoint> outlineOf(double lengthOverall_m, double beam_m);
inline constexpr double kOutlineStep_m = 3.0;

Hull readHull(config::Reader& in);

}  // namespace sagara::core
