#include "ui/trainee/SonarView.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/chart/Format.h"
#include "ui/trainee/RadarColours.h"

namespace sagara::ui::console {
namespace {

using core::SonarPicture;
const double kSide = std::sin(SonarPicture::kHalfSector_rad);

struct Shade {
    double timesDraught;
    QColor colour;
};
/// By depth over the ship's draught: danger, caution, then greener and bluer.
const std::array<Shade, 5> kShades{{{1.2, QColor(0xe6, 0x3c, 0x30)},
                                    {2.0, QColor(0xf0, 0x8c, 0x28)},
                                    {3.0, QColor(0xe8, 0xd0, 0x40)},
                                    {5.0, QColor(0x48, 0xb0, 0x60)},
                                    {1e9, QColor(0x3c, 0x7c, 0xc8)}}};

}  // namespace

SonarView::SonarView(QWidget* parent) : Gauge(tr("Sonar: ahead"), 1.0, parent) {
    setObjectName(QStringLiteral("sonar"));
    setToolTip(
        tr("Forward-looking sonar, 45° on each bow. Bottom by the depth of water: red less than 1.2 times "
           "the draught, orange 2, yellow 3, green 5 times, blue deeper. White: hulls. Below: bottom right "
           "ahead, depths in metres"));
}

void SonarView::setPicture(SonarPicture picture, double draught_m) {
    m_picture = std::move(picture);
    m_draught_m = draught_m;
    update();
}

QColor SonarView::bottomColour(double depth_m) const {
    for (const Shade& shade : kShades)
        if (depth_m < shade.timesDraught * m_draught_m) return shade.colour;
    return kShades.back().colour;
}

void SonarView::drawSector(QPainter& painter, const QRectF& box) {
    const RadarColours& c = radarColours(palette());
    const double dim = palette() == PaletteName::Night ? 0.75 : palette() == PaletteName::Dusk ? 0.8 : 1.0;
    const double radius = std::min(box.height() - 14.0, 0.5 * box.width() / kSide - 2.0);
    const QPointF origin(box.center().x(), box.top() + 8.0 + 0.5 * (box.height() - 14.0 - radius) + radius);
    const int w = std::max(2, static_cast<int>(2.0 * kSide * radius)),
              h = std::max(2, static_cast<int>(radius));
    QImage image(w, h, QImage::Format_RGB32);
    image.fill(c.surround);
    for (int y = 0; y < h; ++y) {
        auto* const line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < w; ++x) {
            const double dx = x + 0.5 - 0.5 * w, dy = h - y - 0.5;
            const double r = std::hypot(dx, dy) / radius;
            const double beam =
                std::atan2(dx, dy) / core::kDegree_rad + 0.5 * static_cast<double>(SonarPicture::kBeams - 1);
            if (r >= 1.0 || beam < -0.5 || beam > static_cast<double>(SonarPicture::kBeams) - 0.5) continue;
            const std::size_t i = m_picture.index(static_cast<std::size_t>(std::lround(std::max(0.0, beam))),
                                                  static_cast<std::size_t>(r * SonarPicture::kCells));
            const double level = dim * m_picture.levels[i] / 255.0;
            QColor colour = Qt::white;
            if (m_picture.contacts[i] == 0) {
                const auto bottom_m = static_cast<double>(m_picture.bottom_m[i]);
                if (std::isnan(bottom_m)) {
                    line[x] = c.water.rgb();
                    continue;
                }
                colour = bottomColour(bottom_m);
            }
            const auto mix = [&](int a, int b) {
                return static_cast<int>(a + (0.25 + 0.75 * level) * dim * (b - a));
            };
            line[x] = qRgb(mix(c.water.red(), colour.red()), mix(c.water.green(), colour.green()),
                           mix(c.water.blue(), colour.blue()));
        }
    }
    painter.drawImage(QPointF(origin.x() - 0.5 * w, origin.y() - h), image);
    const double letters = std::clamp(0.035 * height(), 9.0, 16.0);
    painter.setBrush(Qt::NoBrush);
    for (int ring = 1; ring <= 4; ++ring) {
        const double r = 0.25 * ring * radius;
        painter.setPen(QPen(c.ring, 1.0));
        painter.drawArc(QRectF(origin - QPointF(r, r), QSizeF(2.0 * r, 2.0 * r)), 16 * 45, 16 * 90);
        drawWords(painter, QRectF(origin.x() + 3.0, origin.y() - r + 1.0, 60.0, 1.4 * letters),
                  Qt::AlignLeft | Qt::AlignTop, tr("%1 m").arg(0.25 * ring * m_picture.range_m, 0, 'f', 0),
                  letters, c.scale);
    }
    painter.setPen(QPen(c.ring, 1.0));
    for (const double bearing_deg : {-45.0, -22.5, 0.0, 22.5, 45.0}) {
        const double a = bearing_deg * core::kDegree_rad;
        painter.drawLine(origin, origin + radius * QPointF(std::sin(a), -std::cos(a)));
    }
    painter.setPen(QPen(c.tool, 1.6));
    for (const SonarPicture::Contact& contact : m_picture.found) {
        const double r = contact.range_m / m_picture.range_m * radius;
        const QPointF at =
            origin + r * QPointF(std::sin(contact.bearing_rad), -std::cos(contact.bearing_rad));
        painter.drawEllipse(at, 7.0, 7.0);
        drawWords(painter, QRectF(at.x() + 10.0, at.y() - letters, 90.0, 2.0 * letters),
                  Qt::AlignLeft | Qt::AlignVCenter, tr("%1 m").arg(contact.range_m, 0, 'f', 0), letters,
                  c.tool);
    }
}

void SonarView::drawProfile(QPainter& painter, const QRectF& box) const {
    const RadarColours& c = radarColours(palette());
    constexpr std::size_t kAhead = SonarPicture::kBeams / 2;
    double deepest_m = 2.0 * m_draught_m;
    for (std::size_t cell = 0; cell < SonarPicture::kCells; ++cell) {
        const float bottom_m = m_picture.bottom_m[m_picture.index(kAhead, cell)];
        if (!std::isnan(bottom_m)) deepest_m = std::max(deepest_m, static_cast<double>(bottom_m));
    }
    const double scale_m = 5.0 * std::ceil(1.1 * deepest_m / 5.0);
    painter.fillRect(box, c.water);
    const double wide = box.width() / static_cast<double>(SonarPicture::kCells);
    const auto y = [&](double depth_m) {
        return box.top() + std::clamp(depth_m / scale_m, 0.0, 1.0) * box.height();
    };
    for (std::size_t cell = 0; cell < SonarPicture::kCells; ++cell) {
        const float bottom_m = m_picture.bottom_m[m_picture.index(kAhead, cell)];
        if (std::isnan(bottom_m)) continue;
        const double top = y(static_cast<double>(bottom_m));
        painter.fillRect(
            QRectF(box.left() + wide * static_cast<double>(cell), top, wide + 0.6, box.bottom() - top),
            bottomColour(static_cast<double>(bottom_m)).darker(palette() == PaletteName::Night ? 220 : 130));
    }
    painter.setPen(QPen(c.tool, 1.4, Qt::DashLine));
    painter.drawLine(QPointF(box.left(), y(m_draught_m)), QPointF(box.right(), y(m_draught_m)));
    const double letters = std::clamp(0.035 * height(), 9.0, 16.0);
    const QRectF words = box.adjusted(4.0, 2.0, -4.0, -2.0);
    drawWords(painter, words, Qt::AlignLeft | Qt::AlignTop, tr("0 m"), letters, c.scale);
    drawWords(painter, words, Qt::AlignLeft | Qt::AlignBottom, tr("%1 m").arg(scale_m, 0, 'f', 0), letters,
              c.scale);
    drawWords(painter, words, Qt::AlignRight | Qt::AlignBottom,
              tr("%1 m ahead").arg(m_picture.range_m, 0, 'f', 0), letters, c.scale);
    drawWords(painter, QRectF(words.left(), y(m_draught_m) - 1.4 * letters, words.width(), 1.4 * letters),
              Qt::AlignRight | Qt::AlignBottom, tr("keel"), letters, c.tool);
}

void SonarView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF frame = drawFrame(painter);
    painter.fillRect(frame, radarColours(palette()).surround);
    if (m_picture.range_m <= 0.0) return;
    const double profile = std::clamp(0.2 * frame.height(), 40.0, 160.0);
    drawSector(painter, frame.adjusted(0.0, 0.0, 0.0, -profile - 4.0));
    drawProfile(painter, QRectF(frame.left(), frame.bottom() - profile, frame.width(), profile));
}

}  // namespace sagara::ui::console
