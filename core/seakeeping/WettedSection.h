#pragma once

#include <vector>

#include "core/seakeeping/SectionPanels.h"

namespace sagara::core {

/// A whole section up to the deck, anticlockwise seen from ahead of a hull with starboard at y > 0; z up from
/// the still waterline.
using SectionPolygon = std::vector<SectionPoint>;

/// From a half section, keel to waterline. Above the water the side goes on as it meets it, with a flare of
/// at most 1 in 2.
SectionPolygon wholeSection(const std::vector<SectionPoint>& half, double freeboard_m);

/// What of a section is below a plane that lies `level_m` above its origin when she is heeled by `heel_rad`,
/// starboard side down, against it: area, and moment of the area about the normal of the plane through the
/// origin, to starboard positive.
struct WettedSection {
    double area_m2 = 0.0;
    double moment_m3 = 0.0;
};
WettedSection wettedSection(const SectionPolygon& section, double heel_rad, double level_m);

}  // namespace sagara::core
