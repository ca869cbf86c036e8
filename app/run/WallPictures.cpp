#include "app/run/WallPictures.h"

#include <QImage>
#include <QPainter>
#include <algorithm>

namespace sagara::run {
namespace {

QImage imageOf(const link::Picture& p) {
    return QImage(reinterpret_cast<const uchar*>(p.bgra.data()), static_cast<int>(p.width_px),
                  static_cast<int>(p.height_px), static_cast<qsizetype>(4 * p.width_px),
                  QImage::Format_RGB32);
}

}  // namespace

void WallPictures::add(const std::string& channel, const link::Picture& picture) {
    if (!m_pictures.empty() && m_pictures.begin()->second.frame != picture.frame) m_pictures.clear();
    m_pictures[channel] = picture;
}

std::optional<std::string> WallPictures::write() {
    if (m_pictures.empty()) return std::nullopt;
    int width = 0, height = 0;
    for (const auto& [channel, picture] : m_pictures) {
        width += static_cast<int>(picture.width_px);
        height = std::max(height, static_cast<int>(picture.height_px));
    }
    QImage wall(width, height, QImage::Format_RGB32);
    wall.fill(Qt::black);
    QPainter painter(&wall);
    int left = 0;
    for (const std::string& channel : m_channels) {
        const auto found = m_pictures.find(channel);
        if (found == m_pictures.end()) continue;
        painter.drawImage(left, 0, imageOf(found->second));
        left += static_cast<int>(found->second.width_px);
    }
    painter.end();
    m_pictures.clear();
    const std::string number = std::to_string(m_written + 1);
    const auto path = m_folder / ("wall-" + std::string(4 - std::min<std::size_t>(4, number.size()), '0') +
                                  number + ".png");
    if (!wall.save(QString::fromStdString(path.string())))
        return "cannot write " + path.string() + "; is there room, and may you write there?";
    ++m_written;
    return std::nullopt;
}

}  // namespace sagara::run
