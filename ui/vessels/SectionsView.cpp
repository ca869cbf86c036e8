#include "ui/vessels/SectionsView.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/theme/ThemeColours.h"

namespace sagara::ui {

std::vector<core::HullStation> sectionsOf(const core::Hull& hull) {
    if (!hull.stations.empty()) return hull.stations;
    // Midship section coefficient after Schneekluth and Bertram (1998).
    const double midship = 1.006 - 0.0056 * std::pow(std::clamp(hull.blockCoefficient(), 0.3, 0.9), -3.56);
    const double prismatic = std::clamp(hull.blockCoefficient() / midship, 0.45, 0.93);
    const double waterPower = hull.waterplaneCoefficient / (1.0 - std::min(0.97, hull.waterplaneCoefficient));
    const double areaPower = prismatic / (1.0 - prismatic);
    std::vector<core::HullStation> sections;
    constexpr int kCount = 20;
    for (int i = 0; i <= kCount; ++i) {
        const double s = 2.0 * i / kCount - 1.0;
        core::HullStation station;
        station.x_m = 0.5 * s * hull.lengthBp_m;
        station.breadth_m = hull.beam_m * (1.0 - std::pow(std::abs(s), waterPower));
        station.draught_m = hull.draught_m;
        station.area_m2 =
            std::min(hull.beam_m * hull.draught_m * midship * (1.0 - std::pow(std::abs(s), areaPower)),
                     0.995 * station.breadth_m * station.draught_m);
        sections.push_back(station);
    }
    return sections;
}

double halfBreadth_m(const core::HullStation& s, double depth_m) {
    if (s.draught_m <= 0.0 || s.breadth_m <= 0.0) return 0.0;
    const double fullness = std::clamp(s.area_m2 / (s.breadth_m * s.draught_m), 0.05, 0.995);
    const double n = fullness / (1.0 - fullness);
    return 0.5 * s.breadth_m * (1.0 - std::pow(std::clamp(depth_m / s.draught_m, 0.0, 1.0), n));
}

SectionsView::SectionsView(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("sections"));
    setAccessibleName(tr("Hull sections"));
    setToolTip(tr("Body plan, waterplane and profile below the waterline, metres"));
}

void SectionsView::setHull(std::optional<core::Hull> hull) {
    m_hull = std::move(hull);
    m_sections = m_hull ? sectionsOf(*m_hull) : std::vector<core::HullStation>();
    update();
}

void SectionsView::setColours(PaletteName name) {
    m_colours = name;
    update();
}

void SectionsView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours& c = themeColours(m_colours);
    painter.fillRect(rect(), c.surface);
    if (!m_hull) return;
    const core::Hull& hull = *m_hull;
    QFont bold = font(), small = font();
    bold.setBold(true);
    small.setPointSizeF(0.88 * font().pointSizeF());
    painter.setPen(c.text);
    painter.setFont(bold);
    painter.drawText(QRectF(10, 4, width() - 20, 20), Qt::AlignLeft | Qt::AlignVCenter, tr("Hull sections"));
    painter.setFont(small);
    painter.setPen(c.quietText);
    painter.drawText(QRectF(10, 4, width() - 20, 20), Qt::AlignRight | Qt::AlignVCenter,
                     hull.stations.empty()
                         ? tr("from the form: no stations in the document")
                         : tr("%n stations", nullptr, static_cast<int>(hull.stations.size())));

    // Body plan above, waterplane and profile below it.
    const QRectF plan(14, 30, width() - 28, 0.56 * (height() - 46)),
        below(14, plan.bottom() + 18, width() - 28, height() - plan.bottom() - 24);
    const double draught_m = std::max(hull.draught_m, 0.1);
    const double scale =
        std::min(plan.width() / (1.08 * hull.beam_m), (plan.height() - 16) / (1.12 * draught_m));
    const QPointF middle(plan.center().x(), plan.top() + 12);
    painter.setPen(QPen(c.accent, 1.2));
    painter.drawLine(QPointF(plan.left(), middle.y()), QPointF(plan.right(), middle.y()));
    painter.setPen(QPen(c.line, 1.0, Qt::DashLine));
    painter.drawLine(middle, QPointF(middle.x(), middle.y() + scale * 1.08 * draught_m));
    const std::size_t every = std::max<std::size_t>(1, m_sections.size() / 24);
    for (std::size_t i = 0; i < m_sections.size(); i += every) {
        const core::HullStation& s = m_sections[i];
        const double side = s.x_m >= 0.0 ? 1.0 : -1.0;
        QPainterPath path;
        constexpr int kPoints = 30;
        for (int k = 0; k <= kPoints; ++k) {
            const double z = s.draught_m * k / kPoints;
            const QPointF p(middle.x() + side * scale * halfBreadth_m(s, z), middle.y() + scale * z);
            if (k == 0)
                path.moveTo(p);
            else
                path.lineTo(p);
        }
        painter.setPen(QPen(c.series[s.x_m >= 0.0 ? 0 : 1], 1.2));
        painter.drawPath(path);
    }
    painter.setPen(c.quietText);
    painter.drawText(QRectF(plan.left(), middle.y() + 3, 60, 14), Qt::AlignLeft, tr("aft"));
    painter.drawText(QRectF(plan.right() - 60, middle.y() + 3, 60, 14), Qt::AlignRight, tr("forward"));
    painter.drawText(QRectF(plan.left(), plan.bottom() - 12, plan.width(), 16),
                     Qt::AlignHCenter | Qt::AlignBottom,
                     tr("beam %1 m, draught %2 m").arg(hull.beam_m).arg(hull.draught_m));

    const double across = below.width() / (1.02 * hull.lengthOverall_m);
    const double line_px = below.top() + 0.30 * below.height();
    const double widest = std::min(across, 0.28 * below.height() / (0.5 * hull.beam_m));
    QPainterPath water, keel;
    const auto x = [&](double x_m) { return below.center().x() + across * x_m; };
    const double deep_px = line_px + 0.40 * below.height();
    const double tall = std::min(across, 0.45 * below.height() / draught_m);
    for (std::size_t i = 0; i < m_sections.size(); ++i) {
        const core::HullStation& s = m_sections[i];
        const QPointF w(x(s.x_m), line_px - widest * 0.5 * s.breadth_m);
        const QPointF k(x(s.x_m), deep_px + tall * s.draught_m);
        if (i == 0) {
            water.moveTo(x(s.x_m), line_px);
            keel.moveTo(x(s.x_m), deep_px);
        }
        water.lineTo(w);
        keel.lineTo(k);
    }
    if (!m_sections.empty()) {
        water.lineTo(x(m_sections.back().x_m), line_px);
        keel.lineTo(x(m_sections.back().x_m), deep_px);
        for (auto it = m_sections.rbegin(); it != m_sections.rend(); ++it)
            water.lineTo(x(it->x_m), line_px + widest * 0.5 * it->breadth_m);
        water.closeSubpath();
        keel.closeSubpath();
    }
    painter.setPen(QPen(c.series[0], 1.2));
    painter.setBrush(c.section);
    painter.drawPath(water);
    painter.drawPath(keel);
    painter.setPen(c.quietText);
    painter.drawText(QRectF(below.left(), line_px - 8, below.width(), 16), Qt::AlignCenter, tr("waterplane"));
    painter.drawText(QRectF(below.left(), deep_px + 1, below.width(), 16), Qt::AlignCenter,
                     tr("profile, %1 m overall").arg(hull.lengthOverall_m));
}

}  // namespace sagara::ui
