#pragma once

#include "ui/chart/Graticule.h"
#include "ui/widgets/ChartTransform.h"

namespace sagara::ui {

/// Minutes of arc between the lines of the graticule, for the lines and for their labels.
inline double graticuleStep_min(const ChartTransform& view, double letter_px) {
    return chart::graticuleStep_min(view.toMetres(13.0 * letter_px));
}

}  // namespace sagara::ui
