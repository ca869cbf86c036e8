#include <QFontMetricsF>
#include <cmath>

#include "core/base/Units.h"
#include "ui/widgets/AreaLayers.h"

namespace sagara::ui {
namespace {

/// Metres and, down to 21 m, decimetres set lower and smaller, as charts have it. Cut off, never rounded up:
/// a chart must not promise more water than there is.
struct Sounding {
    QString metres;
    QString decimetre;
};

Sounding soundingOf(double depth_m) {
    const auto decimetres = static_cast<int>(std::floor(10.0 * depth_m + 1e-6));
    if (decimetres >= 210) return {QString::number(decimetres / 10), {}};
    return {QString::number(decimetres / 10),
            decimetres % 10 == 0 ? QString() : QString::number(decimetres % 10)};
}

/// Distance of the soundings: 1, 1.5, 2, 3, 4, 6, 8 ... m on the ground.
double spacing_m(double least_m) {
    const double power = std::exp2(std::floor(std::log2(least_m)));
    if (power >= least_m) return power;
    return 1.5 * power >= least_m ? 1.5 * power : 2.0 * power;
}

class SoundingPainter {
public:
    SoundingPainter(ChartCanvas& canvas, const PreparedChart& chart)
        : m_canvas(canvas),
          m_chart(chart),
          m_big(canvas.letters(0.85, canvas.palette.sounding)),
          m_small(canvas.letters(0.68, canvas.palette.sounding)),
          m_bigMetrics(fontOf(m_big)),
          m_smallMetrics(fontOf(m_small)) {
        m_big.halo = m_small.halo = QColor(0, 0, 0, 0);
    }

    /// The middle of the figures is where the depth is.
    void draw(core::NorthEast p) {
        const double depth_m = m_chart.area->depth_m(p);
        if (depth_m < 0.0 || m_chart.area->isLand(p)) return;
        const Sounding sounding = soundingOf(depth_m);
        const QPointF at = m_canvas.view.toScreen(p);
        const double main = m_bigMetrics.horizontalAdvance(sounding.metres);
        const QSizeF size(main + m_smallMetrics.horizontalAdvance(sounding.decimetre),
                          1.25 * m_bigMetrics.capHeight());
        const QRectF box(at - QPointF(0.5 * size.width(), 0.5 * size.height()), size);
        if (!m_canvas.labels.isFree(box.adjusted(-3.0, -2.0, 3.0, 2.0)) || !allWater(box)) return;
        m_canvas.labels.block(box);
        m_big.colour = m_small.colour =
            depth_m <= m_chart.safety_m ? m_canvas.palette.shoalSounding : m_canvas.palette.sounding;
        drawText(m_canvas.painter, {box.left(), at.y()}, Qt::AlignLeft | Qt::AlignVCenter, sounding.metres,
                 m_big);
        drawText(m_canvas.painter, {box.left() + main, at.y() + 0.34 * m_big.size_px},
                 Qt::AlignLeft | Qt::AlignVCenter, sounding.decimetre, m_small);
    }

private:
    bool allWater(const QRectF& box) const {
        for (const QPointF corner : {box.topLeft(), box.topRight(), box.bottomLeft(), box.bottomRight()}) {
            const core::NorthEast p = m_canvas.view.toChart(corner);
            if (!m_chart.hasDepth(p) || m_chart.area->depth_m(p) <= 0.0 || m_chart.area->isLand(p))
                return false;
        }
        return true;
    }

    ChartCanvas& m_canvas;
    const PreparedChart& m_chart;
    Lettering m_big, m_small;
    QFontMetricsF m_bigMetrics, m_smallMetrics;
};

}  // namespace

/// On a raster that lies fast on the ground, so that no figure jumps when the chart is moved. Every other row
/// is shifted by half a step.
void drawSoundings(ChartCanvas& canvas, const PreparedChart& chart) {
    if (chart.grids.empty()) return;
    const double step_m = spacing_m(canvas.view.toMetres(4.6 * canvas.letter_px));
    const chart::Extent shown = canvas.view.extent();
    SoundingPainter painter(canvas, chart);
    for (double row = std::ceil(shown.southWest.north_m / step_m); row * step_m < shown.northEast.north_m;
         ++row) {
        const double shift = std::fmod(std::abs(row), 2.0) == 1.0 ? 0.5 : 0.0;
        for (double column = std::ceil(shown.southWest.east_m / step_m) - 1.0;
             (column + shift) * step_m < shown.northEast.east_m; ++column) {
            const core::NorthEast p{row * step_m, (column + shift) * step_m};
            if (canvas.frame.contains(canvas.view.toScreen(p)) && chart.hasDepth(p)) painter.draw(p);
        }
    }
}

}  // namespace sagara::ui
