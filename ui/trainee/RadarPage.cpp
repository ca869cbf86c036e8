#include "ui/trainee/RadarPage.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"
#include "ui/chart/Format.h"

namespace sagara::ui::console {
namespace {

constexpr int kFirstRange = 3;  ///< 1.5 M

QString miles(double range_m) {
    const double range_M = range_m / core::kNauticalMile_m;
    return RadarPage::tr("%1 M").arg(chart::number(range_M, range_M < 1.0 ? 3 : 2));
}

}  // namespace

RadarPage::RadarPage(const core::World& world, std::size_t ship, QWidget* parent)
    : QWidget(parent),
      m_world(world),
      m_ship(ship),
      m_scanner(world, ship),
      m_view(new RadarView(this)),
      m_range(new QComboBox(this)),
      m_cursor(new QLabel(this)),
      m_lineText(new QLabel(this)),
      m_markerText(new QLabel(this)) {
    m_view->setPicture(&m_scanner.picture());
    auto* const row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    row->addWidget(m_view, 1);
    auto* const panel = new QWidget(this);
    addControls(panel);
    panel->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
    row->addWidget(panel);
    connect(m_view, &RadarView::cursorMoved, this, &RadarPage::showCursor);
    connect(m_view, &RadarView::toolsMoved, this, &RadarPage::showTools);
    connect(m_view, &RadarView::rangeStepped, this, [this](int steps) {
        m_range->setCurrentIndex(std::clamp(m_range->currentIndex() + steps, 0, m_range->count() - 1));
    });
    showCursor(std::nullopt);
    showTools();
}

void RadarPage::addControls(QWidget* panel) {
    auto* const column = new QVBoxLayout(panel);
    column->setContentsMargins(2, 2, 2, 2);
    column->setSpacing(4);
    auto* const form = new QFormLayout;
    form->setVerticalSpacing(3);
    m_range->setObjectName(QStringLiteral("radar-range"));
    m_range->setToolTip(tr("Range of the screen in miles; mouse wheel on the screen, keys + and −"));
    for (const double range_M : core::kRadarRanges_M)
        m_range->addItem(tr("%1 M").arg(chart::shortNumber(range_M, 2)));
    m_range->setCurrentIndex(kFirstRange);
    connect(m_range, &QComboBox::currentIndexChanged, this, &RadarPage::setRange);
    form->addRow(tr("Range"), m_range);
    auto* const up = new QComboBox(panel);
    up->setObjectName(QStringLiteral("radar-up"));
    up->setToolTip(tr("What is up on the screen"));
    up->addItems({tr("Head up"), tr("North up"), tr("Course up")});
    connect(up, &QComboBox::currentIndexChanged, this,
            [this](int index) { m_view->setUp(static_cast<RadarView::Up>(index)); });
    form->addRow(tr("Screen"), up);
    auto* const gain = new QSlider(Qt::Horizontal, panel);
    gain->setObjectName(QStringLiteral("radar-gain"));
    gain->setRange(0, 100);
    gain->setValue(75);
    gain->setToolTip(tr("Gain, 0 to 100 %: more shows weaker echoes"));
    connect(gain, &QSlider::valueChanged, this, [this](int value) { m_view->setGain(0.01 * value); });
    form->addRow(tr("Gain"), gain);
    column->addLayout(form);
    const auto check = [&](const QString& text, const QString& id, const QString& tip, bool on) {
        auto* const box = new QCheckBox(text, panel);
        box->setObjectName(id);
        box->setToolTip(tip);
        box->setChecked(on);
        column->addWidget(box);
        return box;
    };
    connect(check(tr("Rings"), QStringLiteral("radar-rings"), tr("Fixed range rings"), true),
            &QCheckBox::toggled, m_view, &RadarView::setRings);
    connect(check(tr("Heading line"), QStringLiteral("radar-heading-line"),
                  tr("Line from the ship right ahead"), true),
            &QCheckBox::toggled, m_view, &RadarView::setHeadingLine);
    auto* const line = check(tr("EBL"), QStringLiteral("radar-ebl"),
                             tr("Electronic bearing line: drag it, or click where it is to go"), false);
    column->addWidget(m_lineText);
    auto* const marker = check(tr("VRM"), QStringLiteral("radar-vrm"),
                               tr("Variable range marker: drag it, or click where it is to go"), false);
    column->addWidget(m_markerText);
    connect(line, &QCheckBox::toggled, this, [this](bool on) {
        m_view->setBearingLine(on ? std::optional<double>(m_heading_rad) : std::nullopt);
        showTools();
    });
    connect(marker, &QCheckBox::toggled, this, [this](bool on) {
        m_view->setRangeMarker(on ? std::optional<double>(0.5 * range_m()) : std::nullopt);
        showTools();
    });
    m_lineText->setObjectName(QStringLiteral("radar-ebl-text"));
    m_markerText->setObjectName(QStringLiteral("radar-vrm-text"));
    m_cursor->setObjectName(QStringLiteral("radar-cursor"));
    column->addWidget(new QLabel(tr("Cursor"), panel));
    column->addWidget(m_cursor);
    column->addStretch();
}

/// Room for the longest reading, so that the screen does not jump with the cursor.
void RadarPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        m_cursor->setMinimumWidth(m_cursor->fontMetrics().horizontalAdvance(tr("000°T  P 000° rel.  ")));
}

void RadarPage::setColours(PaletteName name) { m_view->setColours(name); }

void RadarPage::setRange(int index) {
    if (index < 0) return;
    m_scanner.setRange(core::kRadarRanges_M[static_cast<std::size_t>(index)] * core::kNauticalMile_m);
    m_view->update();
}

void RadarPage::advance(core::SimTime time, const core::Snapshot& now) {
    const core::OwnShipView& own = now.ships[m_ship];
    m_scanner.advance(time, now);
    m_heading_rad = own.motion.heading_rad;
    m_convergence_rad = -m_world.area.frame.convergence_rad(own.motion.position());
    std::optional<double> course_rad;
    if (core::length(own.overGround_mps) > 0.2) course_rad = core::bearing_rad({}, own.overGround_mps);
    m_view->setOwnShip(m_heading_rad, course_rad, m_convergence_rad, m_scanner.azimuth());
    showTools();
}

QString RadarPage::bearingText(double bearing_rad) const {
    const double relative_deg = core::wrapPi(bearing_rad - m_heading_rad) / core::kDegree_rad;
    const QString number =
        QStringLiteral("%1").arg(std::lround(std::abs(relative_deg)), 3, 10, QLatin1Char('0'));
    return tr("%1°T  %2 %3° rel.")
        .arg(chart::bearing(core::wrapTwoPi(bearing_rad + m_convergence_rad) / core::kDegree_rad),
             relative_deg < 0.0 ? tr("P") : tr("S"), number);
}

void RadarPage::showTools() {
    const auto set = [](QLabel* label, const QString& text) {
        if (label->text() != text) label->setText(text);
    };
    set(m_lineText, m_view->bearingLine() ? bearingText(*m_view->bearingLine()) : tr("off"));
    set(m_markerText, m_view->rangeMarker() ? miles(*m_view->rangeMarker()) : tr("off"));
}

void RadarPage::showCursor(std::optional<RadarView::Polar> at) {
    m_cursor->setText(at ? QStringLiteral("%1\n%2").arg(bearingText(at->bearing_rad), miles(at->range_m))
                         : tr("outside\n"));
}

}  // namespace sagara::ui::console
