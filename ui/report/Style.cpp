#include "ui/report/Style.h"

namespace sagara::report {

QPen linePen(const QColor& colour, double width_mm, Qt::PenStyle style) {
    return QPen(colour, width_mm, style, Qt::FlatCap, Qt::MiterJoin);
}

QPen dashedPen(const QColor& colour, double width_mm, double dash_mm, double gap_mm) {
    QPen pen = linePen(colour, width_mm);
    pen.setDashPattern({dash_mm / width_mm, gap_mm / width_mm});
    return pen;
}

}  // namespace sagara::report
