#pragma once

#include <QString>

#include "ui/widgets/PreparedChart.h"

namespace sagara::ui::console {

/// Writes a chart of an area on one sheet of A3 as PDF: graticule with its degrees, compass rose, scale and
/// scale bar, notice and datum. `about`: what must be on it; empty: all of the area. Returns why it could not
/// be written, else nothing. Takes some tenths of a second.
QString writeChartSheet(const PreparedChart& chart, chart::Extent about, const QString& path);

}  // namespace sagara::ui::console
