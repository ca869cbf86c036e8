#include "ui/widgets/ForceArrows.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/chart/Format.h"
#include "ui/widgets/ChartCanvas.h"

namespace sagara::ui {
namespace {

constexpr double kLeast_N = 50.0;
constexpr double kStern = -0.46;  ///< of the length

core::BodyPoint placeOf(core::ForceCause cause, const core::Load& load, double length_m) {
    if (cause == core::ForceCause::Rudder || cause == core::ForceCause::Propeller)
        return {kStern * length_m, 0.0};
    // Where the sideways force would have this moment; a force along the ship has no such place.
    if (std::abs(load.sway_N) < 0.05 * std::hypot(load.surge_N, load.sway_N)) return {};
    return {std::clamp(load.yaw_Nm / load.sway_N, -0.5 * length_m, 0.5 * length_m), 0.0};
}

bool isDark(const QColor& behind) { return behind.lightnessF() < 0.4F; }

/// 1, 2 or 5 times a power of ten, not less than the value.
double stepAbove(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= value * (1.0 - 1e-9)) return step * power;
    return 10.0 * power;
}

QString kN(double force_N) {
    const double value = 0.001 * force_N;
    return chart::number(value, value < 10.0 ? 1 : 0);
}

constexpr double kSwatch = 1.6, kBar_px = 60.0;  ///< of the letters

}  // namespace

std::vector<ShownForce> shownForces(const core::ShipForces& forces, double shipLength_m) {
    std::vector<ShownForce> shown;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        const core::Load& load = forces[i];
        const auto cause = static_cast<core::ForceCause>(i);
        if (std::hypot(load.surge_N, load.sway_N) < kLeast_N) continue;
        shown.push_back({cause, placeOf(cause, load, shipLength_m), {load.surge_N, load.sway_N}});
    }
    return shown;
}

QString forceName(core::ForceCause cause) {
    switch (cause) {
        case core::ForceCause::Hull:
            return tr("Hull");
        case core::ForceCause::Rudder:
            return tr("Rudder");
        case core::ForceCause::Propeller:
            return tr("Propeller");
        case core::ForceCause::Wind:
            return tr("Wind");
        case core::ForceCause::Waves:
            return tr("Waves");
        case core::ForceCause::Lines:
            return tr("Lines");
        case core::ForceCause::Anchors:
            return tr("Anchor");
        case core::ForceCause::Contact:
            return tr("Contact");
    }
    return {};
}

QColor forceColour(core::ForceCause cause, const QColor& behind) {
    // Okabe and Ito (2008), darkened for light backgrounds.
    static constexpr std::array<QRgb, core::kForceCauses> kOnDark{
        0xffd0d0d0, 0xffff6a4d, 0xff2fd39b, 0xff6cc4f5, 0xff5e9bff, 0xffe6b422, 0xfff0a0c8, 0xffffffff};
    static constexpr std::array<QRgb, core::kForceCauses> kOnLight{
        0xff4a4a4a, 0xffb83a00, 0xff00714f, 0xff0a6ea8, 0xff2b3fb0, 0xff7d5a00, 0xff9c2f74, 0xff000000};
    return QColor::fromRgb((isDark(behind) ? kOnDark : kOnLight)[static_cast<std::size_t>(cause)]);
}

double forceScale_NPerPx(const std::vector<ShownForce>& forces, double longest_px, double before_NPerPx) {
    double most_N = 0.0;
    for (const ShownForce& force : forces) most_N = std::max(most_N, force.size_N());
    if (most_N == 0.0) return before_NPerPx > 0.0 ? before_NPerPx : 1000.0 / kBar_px;
    const double wanted = stepAbove(most_N / longest_px * kBar_px) / kBar_px;
    const bool suits = most_N <= before_NPerPx * longest_px && wanted > 0.19 * before_NPerPx;
    return suits ? before_NPerPx : wanted;
}

void drawForceArrow(QPainter& painter, QPointF from, QPointF along_px, const QColor& colour,
                    const QColor& halo) {
    const double length = std::hypot(along_px.x(), along_px.y());
    if (length < 2.0) return;
    const QPointF unit = along_px / length, side(-unit.y(), unit.x());
    const double head = std::min(9.0, 0.6 * length);
    const QPointF tip = from + along_px, neck = tip - head * unit;
    const QPolygonF point{tip, neck + 0.45 * head * side, neck - 0.45 * head * side};
    for (const bool outline : {true, false}) {
        const QColor& ink = outline ? halo : colour;
        painter.setPen(QPen(ink, outline ? 5.5 : 2.6, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
        painter.drawLine(from, neck);
        painter.setPen(outline ? QPen(ink, 3.0, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin) : QPen(Qt::NoPen));
        painter.setBrush(ink);
        painter.drawPolygon(point);
    }
    painter.setBrush(Qt::NoBrush);
}

QSizeF forceLegendSize_px(const std::vector<ShownForce>& forces, const Lettering& letters) {
    const double line = 1.25 * lineHeight_px(letters);
    double wide = 0.0;
    for (const ShownForce& force : forces)
        wide = std::max(wide, textWidth_px(forceName(force.cause), letters));
    const double column = wide + (kSwatch + 1.0) * letters.size_px +
                          textWidth_px(QStringLiteral("0000.0 kN"), letters) + letters.size_px;
    const double rows = static_cast<double>(forces.size()) + 1.4;
    return {std::max(column, kBar_px + 5.0 * letters.size_px) + 12.0, rows * line + 10.0};
}

void drawForceLegend(QPainter& painter, QPointF at, const std::vector<ShownForce>& forces, double NPerPx,
                     const Lettering& letters, const QColor& behind) {
    const QRectF box(at, forceLegendSize_px(forces, letters));
    QColor solid = behind;
    solid.setAlpha(232);
    QColor edge = letters.colour;
    edge.setAlpha(90);
    painter.setPen(QPen(edge, 1.0));
    painter.setBrush(solid);
    painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
    const double line = 1.25 * lineHeight_px(letters);
    double y = box.top() + 5.0 + 0.5 * line;
    const double left = box.left() + 6.0, right = box.right() - 6.0;
    for (const ShownForce& force : forces) {
        const QColor colour = forceColour(force.cause, behind);
        painter.setPen(QPen(colour, 3.0, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(QPointF(left, y), QPointF(left + kSwatch * letters.size_px, y));
        drawText(painter, {left + (kSwatch + 0.6) * letters.size_px, y}, Qt::AlignVCenter,
                 forceName(force.cause), letters);
        drawText(painter, {right, y}, Qt::AlignRight | Qt::AlignVCenter, tr("%1 kN").arg(kN(force.size_N())),
                 letters);
        y += line;
    }
    y += 0.2 * line;
    painter.setPen(QPen(letters.colour, 1.6));
    painter.drawLine(QPointF(left, y), QPointF(left + kBar_px, y));
    for (const double x : {left, left + kBar_px}) painter.drawLine(QPointF(x, y - 3.0), QPointF(x, y + 3.0));
    drawText(painter, {left + kBar_px + 0.7 * letters.size_px, y}, Qt::AlignVCenter,
             tr("%1 kN").arg(chart::shortNumber(0.001 * NPerPx * kBar_px, 2)), letters);
}

}  // namespace sagara::ui
