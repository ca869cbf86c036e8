#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/seakeeping/SectionPanels.h"

namespace sagara::core {

/// What a row of stations says of one section. z up from the waterline.
struct SectionData {
    double halfBreadth_m = 0.0;    ///< on the waterline
    double draught_m = 0.0;        ///< of the section itself
    double area_m2 = 0.0;          ///< both sides
    double centroidDepth_m = 0.0;  ///< below the waterline

    double fullness() const { return area_m2 / (2.0 * halfBreadth_m * draught_m); }
};

enum class SectionFit {
    Lewis,       ///< two-parameter conformal map: breadth, draught and area are met
    RoundedBox,  ///< flat bottom, round bilge, wall side: full sections; the same three are met
    Skeg,        ///< flared upper hull over a thin keel: the same and the centroid are met
    Bulb,        ///< wedge over an elliptic lobe: the same
    Plain,       ///< none of these: a power of the depth, its area held to what one can have; an ellipse
                 ///< where there is no waterline
};
const char* nameOf(SectionFit fit);

/// Half section from the keel to the waterline: `panels` + 1 nodes.
struct SectionShape {
    SectionFit fit = SectionFit::Plain;
    std::vector<SectionPoint> nodes;
};

/// Lewis (1929, SNAME 37); range and form after von Kerczek and Tuck (1969, J Ship Res 13, 268-280). None
/// where breadth, draught and area allow no such form, or only one that leaves its own breadth or draught.
std::optional<std::vector<SectionPoint>> lewisSection(const SectionData& data, int panels);

/// The first of the fits above that exists and has the centroid within `kCentroidBand` of the draught.
SectionShape shapeOf(const SectionData& data, int panels);
inline constexpr double kCentroidBand = 0.05;

/// `panels` + 1 nodes along a line of many points, evenly spaced by length and turning angle together.
std::vector<SectionPoint> resampled(const std::vector<SectionPoint>& line, int panels);

/// The same with at least 0.05 of its draught between centreline and side, but for the waterline: panels of
/// `flowAbout` that nearly touch those of the other side have no answer in sway. Thin keels sway as plates
/// do.
std::vector<SectionPoint> thickened(std::vector<SectionPoint> nodes);

}  // namespace sagara::core
