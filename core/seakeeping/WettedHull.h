#pragma once

#include <array>
#include <vector>

#include "core/sea/SeaState.h"
#include "core/seakeeping/HullForm.h"
#include "core/seakeeping/RadiationMemory.h"
#include "core/seakeeping/WettedSection.h"

namespace sagara::core {

/// Where a hull lies in the sea.
struct HullAttitude {
    NorthEast position;
    double heading_rad = 0.0;
    double down_m = 0.0;     ///< of Bo
    double roll_rad = 0.0;   ///< starboard side down
    double pitch_rad = 0.0;  ///< bow up
};

/// What restoring and undisturbed waves do to the hull as she is wetted at an instant, more than they do to
/// her mean wetted hull: section by section the area and the moment under the effective surface, that of the
/// waves at the mean depth of the hull, with its slope across the ship (Froude-Krylov with pressure normal to
/// it), less what goes with them in a straight line. Nothing of it at small motions; at larger ones the flare
/// holds her up, the bow leaves the water, and heel is righted by the GZ curve. Above the water the sides go
/// on as they meet it. Waves that she throws back and makes stay linear.
class WettedHull {
public:
    explicit WettedHull(const HullForm& form);

    /// Heave, roll and pitch alone, frame B about Bo, N and N m. `shelter`: factor on the waves.
    Six correction(const ActiveWaves& waves, const HullAttitude& at, double shelter) const;

private:
    struct Station {
        double x_m;
        double weight_m;  ///< of the trapezoidal rule
        SectionPolygon section;
        double area_m2, breadth_m, momentPerHeel_m3;  ///< of the mean hull, as fitted
    };
    /// Of the sea along the hull, at even steps from aft forward.
    static constexpr std::size_t kSteps = 24;
    struct Surface {
        double level_m = 0.0;
        double slope = 0.0;  ///< up to starboard
    };
    using Surfaces = std::array<Surface, kSteps + 1>;
    Surfaces surfaces(const ActiveWaves& waves, const HullAttitude& at, double shelter) const;
    Surface between(const Surfaces& all, double x_m) const;

    std::vector<Station> m_stations;
    double m_aft_m = 0.0;
    double m_step_m = 0.0;
    double m_meanDepth_m = 0.0;
    double m_weight_Npm3 = 0.0;
    double m_gravityMoment_Nm =
        0.0;  ///< weight times the height of the centre of gravity above the waterline
};

}  // namespace sagara::core
