#pragma once

#include <array>

#include "ui/widgets/ChartScene.h"
#include "ui/widgets/ChartTransform.h"

namespace sagara::ui {

/// Outline of a ship seen from above, in frame N: pointed bow over the forward 30 %, parallel sides, a
/// transom of 85 % of the beam. The same form that core gives ships for contact, in fewer points.
std::array<core::NorthEast, 9> shipOutline(core::NorthEast midship, double heading_rad, double length_m,
                                           double beam_m);

/// Ships longer than this on the screen are drawn to scale, others as a symbol.
constexpr double kToScaleFrom = 1.6;  ///< of the size of letters
inline bool drawnToScale(const ChartTransform& view, double length_m, double letter_px) {
    return view.toPixels(length_m) >= kToScaleFrom * letter_px;
}

}  // namespace sagara::ui
