#include "ui/trainee/SoundingPage.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>

#include "ui/trainee/SonarView.h"
#include "ui/trainee/SounderView.h"

namespace sagara::ui::console {

SoundingPage::SoundingPage(const core::World& world, std::size_t ship, QWidget* parent)
    : QWidget(parent),
      m_world(world),
      m_ship(ship),
      m_sonar(core::sonarOf(world.ships[ship]->vessel)),
      m_sonarView(new SonarView(this)),
      m_sounderView(new SounderView(this)),
      m_range(new QComboBox(this)),
      m_alarm(new QDoubleSpinBox(this)) {
    m_range->setObjectName(QStringLiteral("sonar-range"));
    m_range->setToolTip(tr("Range of the sonar in metres"));
    for (const double range_m : core::kSonarRanges_m) m_range->addItem(tr("%1 m").arg(range_m), range_m);
    m_range->setCurrentIndex(1);
    connect(m_range, &QComboBox::currentIndexChanged, this, [this] { m_pingNow = true; });
    m_alarm->setObjectName(QStringLiteral("depth-alarm"));
    m_alarm->setRange(0.5, 50.0);
    m_alarm->setSingleStep(0.5);
    m_alarm->setDecimals(1);
    m_alarm->setSuffix(tr(" m"));
    m_alarm->setToolTip(tr("Alarm when there is less water under the keel: 0.5 to 50 m"));
    connect(m_alarm, &QDoubleSpinBox::valueChanged, m_sounderView, &SounderView::setAlarm);
    m_alarm->setValue(std::max(1.0, 0.5 * world.ships[ship]->vessel.hull.draught_m));
    auto* const span = new QComboBox(this);
    span->setObjectName(QStringLiteral("sounder-span"));
    span->setToolTip(tr("How many minutes the trace goes back"));
    for (const int minutes : {2, 5, 10}) span->addItem(tr("%1 min").arg(minutes), 60.0 * minutes);
    span->setCurrentIndex(1);
    connect(span, &QComboBox::currentIndexChanged, this,
            [this, span](int index) { m_sounderView->setSpan(span->itemData(index).toDouble()); });

    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    grid->addWidget(m_sonarView, 0, 0);
    grid->addWidget(m_sounderView, 0, 1);
    auto* const sonarRow = new QHBoxLayout;
    sonarRow->addWidget(new QLabel(tr("Range"), this));
    sonarRow->addWidget(m_range);
    sonarRow->addStretch();
    auto* const sounderRow = new QHBoxLayout;
    sounderRow->addWidget(new QLabel(tr("Alarm below"), this));
    sounderRow->addWidget(m_alarm);
    sounderRow->addWidget(new QLabel(tr("Trace"), this));
    sounderRow->addWidget(span);
    sounderRow->addStretch();
    grid->addLayout(sonarRow, 1, 0);
    grid->addLayout(sounderRow, 1, 1);
    grid->setRowStretch(0, 1);
    grid->setColumnStretch(0, 1);
    grid->setColumnStretch(1, 1);
}

void SoundingPage::setColours(PaletteName name) {
    m_sonarView->setColours(name);
    m_sounderView->setColours(name);
}

double SoundingPage::depthAlarm_m() const { return m_alarm->value(); }

void SoundingPage::show(const core::Snapshot& now, const ShipReadings& readings) {
    m_sounderView->add(now.time().seconds(), readings.underKeel_m);
    const std::int64_t second = now.time().us / 1'000'000;
    if (!isVisible() || (second == m_pinged_s && !m_pingNow)) return;
    m_pinged_s = second;
    m_pingNow = false;
    sound(now);
}

void SoundingPage::sound(const core::Snapshot& now) {
    std::vector<core::SonarObject> hulls;
    for (const core::TargetView& t : now.targets) {
        const core::TargetLayout& layout = core::targetLayout(m_world, now.added, t.index);
        hulls.push_back({t.position, t.heading_rad, layout.length_m, layout.beam_m, layout.draught_m});
    }
    for (std::size_t i = 0; i < now.ships.size(); ++i) {
        if (i == m_ship) continue;
        const core::Hull& hull = m_world.ships[i]->vessel.hull;
        const core::ShipMotion& m = now.ships[i].motion;
        hulls.push_back({m.position(), m.heading_rad, hull.lengthOverall_m, hull.beam_m, hull.draught_m});
    }
    const double range_m =
        core::kSonarRanges_m[static_cast<std::size_t>(std::max(0, m_range->currentIndex()))];
    m_sonarView->setPicture(core::ping(m_world.area, hulls, m_sonar, now.ships[m_ship].motion, now.tide_m,
                                       range_m, static_cast<std::uint32_t>(m_pinged_s)),
                            m_world.ships[m_ship]->vessel.hull.draught_m);
}

}  // namespace sagara::ui::console
