#pragma once

#include <complex>
#include <string>
#include <vector>

#include "core/seakeeping/HullForm.h"
#include "core/seakeeping/SectionFlow.h"
#include "core/seakeeping/SectionShape.h"

namespace sagara::core {

/// One section of the hull as strip theory takes it.
struct Strip {
    double x_m = 0.0;  ///< forward of midship
    SectionFit fit = SectionFit::Lewis;
    std::vector<SectionPoint> outline;  ///< half section as fitted, from the keel to the waterline
    std::vector<SectionPanel> panels;   ///< of the flow: the outline, `thickened`
    double breadth_m = 0.0;
    SectionArea stated;  ///< as the station says: hydrostatics and long waves keep to it
    SectionArea fitted;  ///< of the panels
};

inline constexpr int kPanels = 20;  ///< of a half section

/// A strip for each station; one without an area, as at a pointed end, has no panels. Fits other than a Lewis
/// form are told in `notes`.
std::vector<Strip> stripsOf(const HullForm& form, std::vector<std::string>* notes = nullptr);

}  // namespace sagara::core
