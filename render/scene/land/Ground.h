#pragma once

#include <map>
#include <vector>

#include "core/world/Area.h"
#include "render/scene/shape/Solid.h"

namespace sagara::render {

/// The ground at a place: how far from the shore, how high, what colour. Made from coastline, elevation and
/// what the shore is made of.
class Ground {
public:
    explicit Ground(const core::Area& area);

    struct Spot {
        double inland_m = 0.0;  ///< from the nearest shoreline; negative on the water, at most kFar_m
        core::ShoreKind kind = core::ShoreKind::Other;  ///< of that shoreline
        bool fort = false;
    };
    static constexpr double kFar_m = 130.0;  ///< distances are not followed farther

    Spot spot(core::NorthEast p) const;
    /// Above mean sea level; `trees` with what grows on it.
    double height_m(core::NorthEast p, const Spot& spot, bool trees) const;
    Paint paint(core::NorthEast p, const Spot& spot) const;
    bool works(const Spot& spot) const;  ///< quay, jetty or breakwater

private:
    bool inside(core::NorthEast p) const;
    double trees_m(core::NorthEast p, const Spot& spot) const;

    const core::Area& m_area;
    core::NorthEast m_fort{1e9, 1e9};
    /// Where lines of equal north, kRow_m apart, cross the coast, west to east.
    static constexpr double kRow_m = 5.0;
    std::map<int, std::vector<double>> m_rows;
};

/// Smooth noise of a place, 0 to 1, with hills of this size.
double placeNoise(core::NorthEast p, double size_m);

}  // namespace sagara::render
