#include "ui/trainee/RadarView.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/Angle.h"
#include "ui/chart/Format.h"
#include "ui/trainee/RadarColours.h"

namespace sagara::ui::console {
namespace {

constexpr std::uint32_t kOutside = 0xffffffffU;
constexpr unsigned kCellBits = 10;
static_assert(core::RadarPicture::kCells == 1U << kCellBits);
constexpr double kGrab_px = 8.0;
constexpr double kAfterglow = 0.45;  ///< of the brightness is lost within a turn

QString trueText(double bearing_rad) {
    return chart::bearing(core::wrapTwoPi(bearing_rad) / core::kDegree_rad);
}

}  // namespace

double ringStep_m(double range_m) {
    return range_m / (range_m <= 0.5 * core::kNauticalMile_m + 1.0 ? 4.0 : 6.0);
}

RadarView::RadarView(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("ppi"));
    setAccessibleName(tr("Radar"));
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setCursor(Qt::CrossCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void RadarView::setColours(PaletteName name) {
    m_palette = name;
    update();
}

void RadarView::setPicture(const core::RadarPicture* picture) {
    m_picture = picture;
    update();
}

void RadarView::setOwnShip(double heading_rad, std::optional<double> course_rad, double convergence_rad,
                           std::size_t sweptTo) {
    m_heading_rad = heading_rad;
    m_course_rad = course_rad;
    m_convergence_rad = convergence_rad;
    m_sweptTo = sweptTo;
    update();
}

void RadarView::setUp(Up up) {
    m_up = up;
    update();
}

void RadarView::setRings(bool on) {
    m_rings = on;
    update();
}

void RadarView::setHeadingLine(bool on) {
    m_headingLine = on;
    update();
}

void RadarView::setGain(double gain) {
    m_gain = std::clamp(gain, 0.0, 1.0);
    update();
}

void RadarView::setBearingLine(std::optional<double> bearing_rad) {
    m_ebl_rad = bearing_rad;
    update();
}

void RadarView::setRangeMarker(std::optional<double> range_m) {
    m_vrm_m = range_m;
    update();
}

double RadarView::headingUp_rad() const {
    if (m_up == Up::North) return -m_convergence_rad;
    if (m_up == Up::Course) return m_course_rad.value_or(m_heading_rad);
    return m_heading_rad;
}

QPointF RadarView::centre() const { return QRectF(rect()).center(); }

/// Round the screen, for the bearing scale.
double RadarView::margin_px() const { return std::max(20.0, 0.03 * std::min(width(), height())); }

double RadarView::radius_px() const { return 0.5 * std::min(width(), height()) - margin_px(); }

RadarView::Polar RadarView::polarAt(QPointF p) const {
    const QPointF d = p - centre();
    const double range_m = m_picture == nullptr ? 0.0 : m_picture->range_m;
    return {core::wrapTwoPi(std::atan2(d.x(), -d.y()) + headingUp_rad()),
            std::hypot(d.x(), d.y()) / radius_px() * range_m};
}

QPointF RadarView::placeOf(const Polar& polar) const {
    if (m_picture == nullptr || m_picture->range_m <= 0.0) return centre();
    const double r = polar.range_m / m_picture->range_m * radius_px();
    const double a = polar.bearing_rad - headingUp_rad();
    return centre() + r * QPointF(std::sin(a), -std::cos(a));
}

void RadarView::makeTable(int side) {
    m_image = QImage(side, side, QImage::Format_RGB32);
    m_table.assign(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), kOutside);
    const double middle = 0.5 * (side - 1), radius = 0.5 * side;
    std::size_t i = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x, ++i) {
            const double dx = x - middle, dy = y - middle;
            const double r = std::sqrt(dx * dx + dy * dy) / radius;
            if (r >= 1.0) continue;
            const double turn = std::atan2(dx, -dy) / core::RadarPicture::kStep_rad;
            constexpr int kAll = static_cast<int>(core::RadarPicture::kAzimuths);
            const int azimuth = (static_cast<int>(std::lround(turn)) + kAll) % kAll;
            const auto cell = static_cast<std::uint32_t>(r * core::RadarPicture::kCells);
            m_table[i] = static_cast<std::uint32_t>(azimuth) << kCellBits | cell;
        }
}

void RadarView::drawEchoes(QPainter& painter) {
    const double ratio = devicePixelRatioF();
    const int side = std::max(2, static_cast<int>(2.0 * radius_px() * ratio));
    if (m_image.width() != side) makeTable(side);
    const RadarColours& c = radarColours(m_palette);
    const RadarPalette palette(c, m_gain);
    constexpr std::size_t kAll = core::RadarPicture::kAzimuths;
    const auto turned = std::lround(core::wrapTwoPi(headingUp_rad()) / core::RadarPicture::kStep_rad);
    // Azimuth of the picture and shade of its age, for every azimuth of the screen.
    std::array<const std::uint8_t*, kAll> rows{};
    std::array<const QRgb*, kAll> shades{};
    for (std::size_t a = 0; a < kAll; ++a) {
        const std::size_t azimuth = (a + static_cast<std::size_t>(turned)) % kAll;
        const std::size_t age = (m_sweptTo + kAll - azimuth) % kAll;
        rows[a] = m_picture->levels.data() + azimuth * core::RadarPicture::kCells;
        shades[a] = palette.shade(1.0 - kAfterglow * static_cast<double>(age) / static_cast<double>(kAll));
    }
    const QRgb outside = c.surround.rgb();
    std::size_t i = 0;
    for (int y = 0; y < side; ++y) {
        auto* const line = reinterpret_cast<QRgb*>(m_image.scanLine(y));
        for (int x = 0; x < side; ++x, ++i) {
            const std::uint32_t at = m_table[i];
            line[x] =
                at == kOutside
                    ? outside
                    : shades[at >> kCellBits][rows[at >> kCellBits][at & (core::RadarPicture::kCells - 1)]];
        }
    }
    const double r = radius_px();
    painter.drawImage(QRectF(centre() - QPointF(r, r), QSizeF(2.0 * r, 2.0 * r)), m_image);
}

void RadarView::drawScale(QPainter& painter) const {
    const RadarColours& c = radarColours(m_palette);
    const double r = radius_px();
    QFont letters = font();
    letters.setPixelSize(std::clamp(static_cast<int>(0.035 * r), 9, 26));
    painter.setFont(letters);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(c.scale, 1.2));
    painter.drawEllipse(centre(), r, r);
    const double up_rad = headingUp_rad() + m_convergence_rad;
    for (int deg = 0; deg < 360; deg += 5) {
        const double a = deg * core::kDegree_rad - up_rad;
        const QPointF out(std::sin(a), -std::cos(a));
        const double tick = deg % 30 == 0 ? 7.0 : deg % 10 == 0 ? 5.0 : 3.0;
        painter.drawLine(centre() + r * out, centre() + (r + tick) * out);
        if (deg % 30 != 0) continue;
        const QPointF at = centre() + (r + 0.72 * margin_px()) * out;
        painter.drawText(QRectF(at - QPointF(40.0, 20.0), QSizeF(80.0, 40.0)), Qt::AlignCenter,
                         QStringLiteral("%1").arg(deg, 3, 10, QLatin1Char('0')));
    }
    if (m_rings) {
        painter.setPen(QPen(c.ring, 1.0));
        const double step_px = ringStep_m(m_picture->range_m) / m_picture->range_m * r;
        for (double ring = step_px; ring < r - 1.0; ring += step_px)
            painter.drawEllipse(centre(), ring, ring);
    }
    if (m_headingLine) {
        painter.setPen(QPen(c.scale, 1.4));
        painter.drawLine(centre(), placeOf({m_heading_rad, m_picture->range_m}));
    }
    const QPointF north = placeOf({-m_convergence_rad, m_picture->range_m});
    const QPointF in = (centre() - north) / r;
    painter.setBrush(c.scale);
    const QPointF across(-in.y(), in.x());
    painter.drawPolygon(QPolygonF{north, north + 9.0 * in + 4.0 * across, north + 9.0 * in - 4.0 * across});
    const double sweep = static_cast<double>(m_sweptTo) * core::RadarPicture::kStep_rad;
    painter.setPen(QPen(c.sweep, 1.5));
    painter.drawLine(centre(), placeOf({sweep, m_picture->range_m}));
}

void RadarView::drawTools(QPainter& painter) const {
    const RadarColours& c = radarColours(m_palette);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(c.tool, 1.4, Qt::DashLine));
    if (m_ebl_rad) painter.drawLine(centre(), placeOf({*m_ebl_rad, m_picture->range_m}));
    if (m_vrm_m && *m_vrm_m < m_picture->range_m) {
        const double r = *m_vrm_m / m_picture->range_m * radius_px();
        painter.drawEllipse(centre(), r, r);
    }
    painter.setPen(c.scale);
    const QString scale = tr("%1 M").arg(chart::shortNumber(m_picture->range_m / core::kNauticalMile_m, 2));
    const QString rings =
        tr("rings %1 M").arg(chart::shortNumber(ringStep_m(m_picture->range_m) / core::kNauticalMile_m, 3));
    const QString up = m_up == Up::Head    ? tr("Head up")
                       : m_up == Up::North ? tr("North up")
                                           : tr("Course up");
    const QRectF corner = QRectF(rect()).adjusted(6.0, 4.0, -6.0, -4.0);
    painter.drawText(corner, Qt::AlignLeft | Qt::AlignTop,
                     scale + QLatin1Char('\n') + (m_rings ? rings : QString()));
    painter.drawText(
        corner, Qt::AlignRight | Qt::AlignTop,
        up + QLatin1Char('\n') + tr("HDG %1°T").arg(trueText(m_heading_rad + m_convergence_rad)));
}

void RadarView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), radarColours(m_palette).surround);
    if (m_picture == nullptr || m_picture->range_m <= 0.0 || radius_px() < 20.0) return;
    drawEchoes(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    drawScale(painter);
    drawTools(painter);
}

void RadarView::resizeEvent(QResizeEvent*) { m_image = QImage(); }

void RadarView::moveTools(const Polar& to) {
    if (m_dragsLine) m_ebl_rad = to.bearing_rad;
    if (m_dragsMarker) m_vrm_m = std::min(to.range_m, m_picture->range_m);
    if (m_dragsLine || m_dragsMarker) Q_EMIT toolsMoved();
    update();
}

/// A line or ring under the mouse is dragged alone; anywhere else both jump there.
void RadarView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || m_picture == nullptr) return;
    const Polar at = polarAt(event->position());
    const double perMetre = radius_px() / m_picture->range_m;
    const bool onMarker = m_vrm_m && std::abs(at.range_m - *m_vrm_m) * perMetre < kGrab_px;
    const bool onLine =
        m_ebl_rad && std::abs(core::wrapPi(at.bearing_rad - *m_ebl_rad)) * at.range_m * perMetre < kGrab_px;
    m_dragsLine = m_ebl_rad && (onLine || !onMarker);
    m_dragsMarker = m_vrm_m && (onMarker || !onLine);
    moveTools(at);
}

void RadarView::mouseMoveEvent(QMouseEvent* event) {
    if (m_picture == nullptr) return;
    const Polar at = polarAt(event->position());
    if (event->buttons() & Qt::LeftButton) moveTools(at);
    if (at.range_m <= m_picture->range_m)
        Q_EMIT cursorMoved(at);
    else
        Q_EMIT cursorMoved(std::nullopt);
}

void RadarView::mouseReleaseEvent(QMouseEvent*) { m_dragsLine = m_dragsMarker = false; }

void RadarView::leaveEvent(QEvent*) { Q_EMIT cursorMoved(std::nullopt); }

void RadarView::wheelEvent(QWheelEvent* event) {
    const int steps = event->angleDelta().y() / 120;
    if (steps != 0) Q_EMIT rangeStepped(-steps);
    event->accept();
}

}  // namespace sagara::ui::console
