#pragma once

#include <vector>

namespace sagara::core {

/// A point of a cross-section: y from the centreline, z up from the still waterline (not frame B, whose z is
/// down).
struct SectionPoint {
    double y_m = 0.0;
    double z_m = 0.0;
};

/// One straight piece of the immersed half section y >= 0, and its normal, out of the hull.
struct SectionPanel {
    SectionPoint from;
    SectionPoint to;
    SectionPoint middle;
    double length_m = 0.0;
    double normalY = 0.0;
    double normalZ = 0.0;
    /// Of rolling about the waterline on the centreline: y nz - z ny.
    double normalRoll_m() const { return middle.y_m * normalZ - middle.z_m * normalY; }
};

/// Panels between the nodes of a half section, given from the keel to the waterline. Symmetric about y = 0.
std::vector<SectionPanel> panelsOf(const std::vector<SectionPoint>& nodes);

/// Both sides of what the panels enclose with the waterline.
struct SectionArea {
    double area_m2 = 0.0;
    double depth_m = 0.0;  ///< of its centroid below the waterline
};
SectionArea areaOf(const std::vector<SectionPanel>& panels);

}  // namespace sagara::core
