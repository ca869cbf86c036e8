#include "ui/widgets/ForceArrows.h"
#include "ui/widgets/SceneLayers.h"

namespace sagara::ui {
namespace {

constexpr double kLongest = 9.0;  ///< arrow, of the letters

}  // namespace

/// Over the first own ship, with a legend at the upper right.
void drawForces(ChartCanvas& canvas, const ChartScene& scene) {
    if (scene.forces.empty() || scene.ownShips.empty()) return;
    const ChartShip& ship = scene.ownShips.front();
    const core::HeadingFrame frame(ship.position, ship.heading_rad);
    const double NPerPx = scene.forceScale_NPerPx > 0.0
                              ? scene.forceScale_NPerPx
                              : forceScale_NPerPx(scene.forces, kLongest * canvas.letter_px, 0.0);
    const QColor behind = canvas.palette.safe;
    for (const ShownForce& force : scene.forces) {
        const QPointF from = canvas.view.toScreen(frame.point(force.at));
        // A direction turns with the chart, its length is of the force.
        const core::NorthEast way = frame.vector(force.force_N);
        const QPointF along = canvas.view.toScreen(ship.position + way) - canvas.view.toScreen(ship.position);
        drawForceArrow(canvas.painter, from, canvas.view.metresPerPixel() / NPerPx * along,
                       forceColour(force.cause, behind), canvas.palette.halo);
    }
    const Lettering letters{0.92 * canvas.letter_px, canvas.palette.panelInk, QColor(0, 0, 0, 0), false,
                            false};
    const QSizeF size = forceLegendSize_px(scene.forces, letters);
    QColor panel = canvas.palette.panel;
    panel.setAlpha(255);
    drawForceLegend(canvas.painter, {canvas.frame.right() - size.width() - 8.0, canvas.frame.top() + 8.0},
                    scene.forces, NPerPx, letters, panel);
}

}  // namespace sagara::ui
