#include "ui/widgets/ChartPicture.h"

#include <cmath>

#include "ui/widgets/AreaLayers.h"

namespace sagara::ui {
namespace {

constexpr double kMargin_px = 128.0;
/// Layers the area is made of: switching another one leaves the picture as it is.
constexpr ChartLayers kAreaLayers = ChartLayers::fromInt(0x7fu);

}  // namespace

/// Where the picture's corner lies on the screen.
QPointF ChartPicture::offset(const ChartTransform& view) const {
    return view.toScreen(m_view.centre()) - m_view.middle();
}

bool ChartPicture::serves(const Look& look, const ChartTransform& view) const {
    if (m_image.isNull() || m_look != look || m_view.metresPerPixel() != view.metresPerPixel() ||
        m_view.up_rad() != view.up_rad()) {
        return false;
    }
    const QRectF covered(offset(view), m_view.size());
    return covered.contains(QRectF(QPointF(), view.size()));
}

void ChartPicture::show(const Look& wanted, const ChartTransform& view) {
    Look look = wanted;
    look.shown &= kAreaLayers;
    if (serves(look, view)) return;
    m_look = look;
    m_view = view.resized(view.size() + QSizeF(2.0 * kMargin_px, 2.0 * kMargin_px));
    const QSizeF pixels = look.devicePixelRatio * m_view.size();
    m_image = QImage(pixels.toSize(), QImage::Format_RGB32);
    m_image.setDevicePixelRatio(look.devicePixelRatio);
    QPainter painter(&m_image);
    painter.setRenderHint(QPainter::Antialiasing);
    ChartCanvas canvas(painter, m_view, chartPalette(look.palette), look.shown, look.letter_px,
                       look.pixel_mm);
    m_names = drawArea(canvas, *look.chart);
    ++m_made;
}

std::vector<QRectF> ChartPicture::names(const ChartTransform& view) const {
    const QRectF screen(QPointF(), view.size());
    std::vector<QRectF> seen;
    for (const QRectF& box : m_names) {
        const QRectF shifted = box.translated(offset(view));
        if (shifted.intersects(screen)) seen.push_back(shifted);
    }
    return seen;
}

void ChartPicture::draw(QPainter& painter, const ChartTransform& view) const {
    const QPointF at = offset(view);
    const double ratio = m_look.devicePixelRatio;  // on whole pixels of the device, or it would blur
    painter.drawImage(QPointF(std::round(ratio * at.x()) / ratio, std::round(ratio * at.y()) / ratio),
                      m_image);
}

}  // namespace sagara::ui
