#include "ui/trainer/ReadingStrip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <cmath>

#include "core/base/Angle.h"
#include "core/base/Units.h"
#include "ui/chart/Format.h"
#include "ui/widgets/Measure.h"

namespace sagara::ui {
namespace {

constexpr int kCell_px = 78, kWideCell_px = 96;
bool isWide(std::size_t i) { return i == 3 || i == 6; }

}  // namespace

ReadingStrip::ReadingStrip(const core::World& world, std::size_t ship, QWidget* parent)
    : QWidget(parent), m_world(world), m_ship(ship) {
    setObjectName(QStringLiteral("readings"));
    setMinimumWidth(kCell_px);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* const line = new QHBoxLayout(this);
    line->setContentsMargins(6, 2, 6, 2);
    line->setSpacing(4);
    const std::array<std::pair<QString, QString>, kReadings> names{
        {{tr("HDG °T"), tr("True heading")},
         {tr("COG °T"), tr("Course over ground")},
         {tr("SOG kn"), tr("Speed over ground")},
         {tr("ROT °/min"), tr("Rate of turn, P to port, S to starboard")},
         {tr("Rudder °"), tr("Rudder angle, P to port, S to starboard")},
         {tr("UKC m"), tr("Water under the keel")},
         {tr("Wind °T kn"), tr("True wind, from where and how strong")}}};
    for (std::size_t i = 0; i < kReadings; ++i) {
        auto* const cell = new QWidget(this);
        cell->setFixedWidth(isWide(i) ? kWideCell_px : kCell_px);
        cell->setToolTip(names[i].second);
        auto* const column = new QVBoxLayout(cell);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(0);
        auto* const name = new QLabel(names[i].first, cell);
        QFont small = name->font();
        small.setPointSizeF(0.82 * small.pointSizeF());
        name->setFont(small);
        m_values[i] = new QLabel(QStringLiteral("–"), cell);
        QFont large = font();
        large.setBold(true);
        large.setPointSizeF(1.2 * large.pointSizeF());
        m_values[i]->setFont(large);
        column->addWidget(name);
        column->addWidget(m_values[i]);
        line->addWidget(cell);
        m_cells[i] = cell;
    }
    line->addStretch();
}

void ReadingStrip::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

void ReadingStrip::fit() {
    int used = 12;
    for (std::size_t i = 0; i < kReadings; ++i) {
        used += (isWide(i) ? kWideCell_px : kCell_px) + 4;
        m_cells[i]->setVisible(used <= width());
    }
}

void ReadingStrip::show(const core::Snapshot& now) {
    if (m_ship >= now.ships.size()) return;
    const core::OwnShipView& s = now.ships[m_ship];
    const core::ShipMotion& m = s.motion;
    const auto trueBearing = [&](double grid_rad) {
        return chart::bearing(trueDirection_rad(m_world.area.frame, m.position(), grid_rad) /
                              core::kDegree_rad);
    };
    const auto sided = [](double value, int decimals) {
        const QString number = chart::number(std::abs(value), decimals);
        return number.toDouble() == 0.0
                   ? number
                   : number + (value < 0.0 ? QStringLiteral(" P") : QStringLiteral(" S"));
    };
    const double over_mps = core::length(s.overGround_mps);
    const QString texts[kReadings] = {
        trueBearing(m.heading_rad),
        over_mps > 0.1 ? trueBearing(core::bearing_rad({}, s.overGround_mps)) : QStringLiteral("–"),
        chart::number(over_mps / core::kKnot_mps, 1),
        sided(60.0 * m.yawRate_radps / core::kDegree_rad, 0),
        sided(s.rudder_rad / core::kDegree_rad, 0),
        s.aground ? tr("aground") : chart::number(s.underKeel_m, 1),
        tr("%1  %2").arg(trueBearing(now.wind.windFrom_rad),
                         chart::number(now.wind.speed_mps / core::kKnot_mps, 0))};
    for (std::size_t i = 0; i < kReadings; ++i) m_values[i]->setText(texts[i]);
}

}  // namespace sagara::ui
