#pragma once

#include <QColor>
#include <QPainter>
#include <QString>
#include <vector>

#include "core/exercise/Forces.h"
#include "ui/widgets/ChartScene.h"
#include "ui/widgets/ScreenText.h"

/// Arrows for what pushes an own ship, on the chart and on the plan.
namespace sagara::ui {

/// Rudder and propellers push at the stern; of the others the place follows from their yaw moment, as far as
/// it lies on the ship. Causes that hardly push are left out.
std::vector<ShownForce> shownForces(const core::ShipForces& forces, double shipLength_m);

QString forceName(core::ForceCause cause);
/// Told apart by the colour blind too, and readable on what is behind.
QColor forceColour(core::ForceCause cause, const QColor& behind);

/// Newtons to a pixel, in steps of 1, 2 and 5, so that the longest arrow has at most so many pixels. Keeps
/// what it was while that still suits: arrows must not jump.
double forceScale_NPerPx(const std::vector<ShownForce>& forces, double longest_px, double before_NPerPx);

void drawForceArrow(QPainter& painter, QPointF from, QPointF along_px, const QColor& colour,
                    const QColor& halo);
/// Names in their colours with kN, and a bar of the scale. The box it takes, with its corner at `at`.
QSizeF forceLegendSize_px(const std::vector<ShownForce>& forces, const Lettering& letters);
void drawForceLegend(QPainter& painter, QPointF at, const std::vector<ShownForce>& forces, double NPerPx,
                     const Lettering& letters, const QColor& behind);

}  // namespace sagara::ui
