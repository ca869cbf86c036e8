#pragma once

#include <string>
#include <vector>

#include "app/import/CoastSource.h"
#include "app/import/ElevationSource.h"
#include "app/import/ImportDescription.h"
#include "app/import/Raster.h"

namespace sagara::importer {

/// A modelled sea bed, for coasts where no survey is open. The natural bed is an equilibrium profile, depth =
/// A d^m with d the distance to the nearest natural shore (Bruun 1954; Dean 1991, Journal of Coastal Research
/// 7(1); m = 2/3), bent towards reported soundings; dredged and other known parts limit it from below or
/// above. There are no bars, banks or rocks but those described. Where people built the shore, the depth goes
/// on behind the face, so that it is whole right up to it; natural land rises as the profile falls.
class DepthModel {
public:
    DepthModel(const DepthRules& rules, const LocalCoast& coast, const ElevationSource& elevation,
               double landAtLeast_m, const core::LocalFrame& frame);

    /// Below chart datum at every node; land negative.
    std::vector<double> depths_m(const Raster& raster) const;
    double waterDepth_m(core::NorthEast p) const;  ///< as if p were water
    double profile_m(core::NorthEast p) const;     ///< of the natural bed before soundings

private:
    struct Bend {
        core::NorthEast at;
        double excess;  ///< sounding over profile, less one
    };
    struct Bed {
        std::vector<core::NorthEast> points;
        const BedRules* rules;
        double outside_m(core::NorthEast p) const;
    };
    double bend(core::NorthEast p) const;
    double landDepth_m(core::NorthEast p) const;
    bool isMadeGround(core::NorthEast p) const;

    const DepthRules& m_rules;
    const LocalCoast& m_coast;
    const ElevationSource& m_elevation;
    const core::LocalFrame& m_frame;
    double m_landAtLeast_m;
    std::vector<Bend> m_bends;
    std::vector<Bed> m_beds;
};

}  // namespace sagara::importer
