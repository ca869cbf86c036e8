#include "ui/trainer/PlanView.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "ui/chart/Format.h"
#include "ui/theme/ThemeColours.h"
#include "ui/trainer/Instruments.h"
#include "ui/widgets/ScreenText.h"

namespace sagara::ui {
namespace {

/// Frame B with the bow up the screen.
QPointF onScreen(core::BodyPoint p, double px_perM) { return {px_perM * p.y_m, -px_perM * p.x_m}; }

}  // namespace

PlanView::PlanView(const core::OwnShip& ship, QWidget* parent) : QWidget(parent), m_ship(ship) {
    setObjectName(QStringLiteral("plan"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("The ship from above"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PlanView::setColours(PaletteName name) {
    m_palette = name;
    update();
}

void PlanView::show(const core::ShipMotion& motion, double rudder_rad, std::vector<ShownForce> forces) {
    m_motion = motion;
    m_rudder_rad = rudder_rad;
    m_forces = std::move(forces);
    m_scale_NPerPx = forceScale_NPerPx(m_forces, 0.28 * std::min(width(), height()), m_scale_NPerPx);
    update();
}

void PlanView::drawShip(QPainter& painter, double px_perM) const {
    const ThemeColours& c = themeColours(m_palette);
    QPolygonF hull;
    for (const core::BodyPoint& p : m_ship.hull.outline) hull << onScreen(p, px_perM);
    painter.setPen(QPen(c.text, 1.6));
    painter.setBrush(c.section);
    painter.drawPolygon(hull);
    painter.setPen(QPen(c.line, 1.0, Qt::DashLine));
    const double half = 0.5 * m_ship.hull.length_m;
    painter.drawLine(onScreen({half, 0.0}, px_perM), onScreen({-half, 0.0}, px_perM));
    // Rudders, larger than they are: a blade of a twelfth of the length.
    painter.setPen(QPen(c.text, 3.0, Qt::SolidLine, Qt::RoundCap));
    const double blade_m = m_ship.hull.length_m / 12.0;
    for (const core::BodyPoint& stock : m_ship.vessel.steering.rudders) {
        // To starboard its trailing edge goes to starboard.
        const core::BodyPoint end{stock.x_m - blade_m * std::cos(m_rudder_rad),
                                  stock.y_m + blade_m * std::sin(m_rudder_rad)};
        painter.drawLine(onScreen(stock, px_perM), onScreen(end, px_perM));
    }
}

void PlanView::drawMotion(QPainter& painter, double px_perM) const {
    const ThemeColours& c = themeColours(m_palette);
    const double way_mps = std::hypot(m_motion.surge_mps, m_motion.sway_mps);
    const double reach = 0.62 * m_ship.hull.length_m;
    if (way_mps > 0.1) {
        const core::BodyPoint way{reach * m_motion.surge_mps / way_mps, reach * m_motion.sway_mps / way_mps};
        painter.setPen(QPen(c.accent, 1.6, Qt::DashLine));
        painter.drawLine(QPointF(), onScreen(way, px_perM));
    }
    const auto pivot_m = pivotAhead_m(m_motion);
    if (!pivot_m || std::abs(*pivot_m) > 0.75 * m_ship.hull.length_m) return;
    const QPointF at = onScreen({*pivot_m, 0.0}, px_perM);
    painter.setPen(QPen(c.setValue, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, 6.0, 6.0);
    painter.drawLine(at - QPointF(10.0, 0.0), at + QPointF(10.0, 0.0));
    painter.drawLine(at - QPointF(0.0, 10.0), at + QPointF(0.0, 10.0));
}

void PlanView::paintEvent(QPaintEvent*) {
    const ThemeColours& c = themeColours(m_palette);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), c.surface);
    const double px_perM =
        std::min((height() - 70.0) / m_ship.hull.length_m, 0.8 * width() / m_ship.hull.length_m);
    const Lettering words{11.0, c.text, QColor(0, 0, 0, 0), false, false};
    double named_px = 0.0;  // the forces' names stand at the left, the ship in the middle of the rest
    if (!m_forces.empty()) {
        drawForceLegend(painter, {6.0, 6.0}, m_forces, m_scale_NPerPx, words, c.surface);
        named_px = 6.0 + forceLegendSize_px(m_forces, words).width();
    }
    painter.save();
    painter.translate(named_px + 0.5 * (width() - named_px), 0.5 * height() - 14.0);
    drawShip(painter, px_perM);
    drawMotion(painter, px_perM);
    for (const ShownForce& force : m_forces) {
        if (m_scale_NPerPx <= 0.0) break;
        drawForceArrow(painter, onScreen(force.at, px_perM), onScreen(force.force_N, 1.0 / m_scale_NPerPx),
                       forceColour(force.cause, c.surface), c.surface);
    }
    painter.restore();

    const auto pivot_m = pivotAhead_m(m_motion);
    const QString pivot = pivot_m && std::abs(*pivot_m) < 1000.0
                              ? (*pivot_m >= 0.0 ? tr("Pivot point %1 m ahead of midship (%2 %)")
                                                 : tr("Pivot point %1 m abaft midship (%2 %)"))
                                    .arg(std::abs(*pivot_m), 0, 'f', 0)
                                    .arg(100.0 * std::abs(*pivot_m) / m_ship.hull.length_m, 0, 'f', 0)
                              : tr("No pivot point: she does not turn");
    painter.setPen(QPen(c.setValue, 2.0));
    painter.drawEllipse(QPointF(14.0, height() - 12.0), 4.0, 4.0);
    drawText(painter, {24.0, height() - 12.0}, Qt::AlignVCenter, elided(pivot, words, width() - 30.0), words);
    painter.setPen(QPen(c.accent, 1.6, Qt::DashLine));
    painter.drawLine(QPointF(6.0, height() - 29.0), QPointF(20.0, height() - 29.0));
    drawText(painter, {24.0, height() - 29.0}, Qt::AlignVCenter, tr("way through the water"), words);
}

}  // namespace sagara::ui
