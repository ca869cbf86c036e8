#include "ui/widgets/ScreenText.h"

#include <QFontMetricsF>
#include <QHash>
#include <QStaticText>
#include <algorithm>
#include <array>
#include <cmath>

namespace sagara::ui {
namespace {

constexpr double kHalo = 0.11;  ///< of the size of the letters

/// The letters in the halo's colour all round their place, then the letters. They are shaped once and come
/// from Qt's cache of glyphs: far quicker than an outline, which counts where ships move.
void drawWithHalo(QPainter& painter, QPointF baseline, double ascent, const QString& text,
                  const Lettering& lettering) {
    const double r = std::max(1.0, kHalo * lettering.size_px), d = 0.7 * r;
    const std::array<QPointF, 8> around{QPointF(r, 0), QPointF(-r, 0), QPointF(0, r),  QPointF(0, -r),
                                        QPointF(d, d), QPointF(d, -d), QPointF(-d, d), QPointF(-d, -d)};
    QStaticText shaped(text);
    shaped.setTextFormat(Qt::PlainText);
    const QPointF at = baseline - QPointF(0.0, ascent);
    painter.setPen(lettering.halo);
    for (const QPointF& shift : around) painter.drawStaticText(at + shift, shaped);
    painter.setPen(lettering.colour);
    painter.drawStaticText(at, shaped);
}

}  // namespace

/// Looking up a font takes as long as drawing ten words with it, and a chart uses a dozen of them all the
/// time.
QFont fontOf(const Lettering& lettering) {
    thread_local QHash<int, QFont> known;
    const int size = std::max(6, static_cast<int>(std::lround(lettering.size_px)));
    const int key = 4 * size + (lettering.bold ? 2 : 0) + (lettering.italic ? 1 : 0);
    const auto found = known.constFind(key);
    if (found != known.constEnd()) return *found;
    QFont font;
    font.setFamilies(
        {QStringLiteral("Noto Sans"), QStringLiteral("DejaVu Sans"), QStringLiteral("Sans Serif")});
    font.setPixelSize(size);
    font.setBold(lettering.bold);
    font.setItalic(lettering.italic);
    return *known.insert(key, font);
}

double textWidth_px(const QString& text, const Lettering& lettering) {
    return QFontMetricsF(fontOf(lettering)).horizontalAdvance(text);
}

double lineHeight_px(const Lettering& lettering) { return std::ceil(1.25 * lettering.size_px); }

QSizeF textSize_px(const QStringList& lines, const Lettering& lettering) {
    const QFontMetricsF metrics(fontOf(lettering));
    double widest = 0.0;
    for (const QString& line : lines) widest = std::max(widest, metrics.horizontalAdvance(line));
    return {widest, lineHeight_px(lettering) * static_cast<double>(lines.size())};
}

QString elided(const QString& text, const Lettering& lettering, double width_px) {
    return QFontMetricsF(fontOf(lettering)).elidedText(text, Qt::ElideRight, width_px);
}

void drawText(QPainter& painter, QPointF at, Qt::Alignment alignment, const QString& text,
              const Lettering& lettering, double turned_deg) {
    const QFont font = fontOf(lettering);
    const QFontMetricsF metrics(font);
    const double width = metrics.horizontalAdvance(text);
    QPointF start(0.0, 0.0);
    if (alignment & Qt::AlignRight) start.setX(-width);
    if (alignment & Qt::AlignHCenter) start.setX(-0.5 * width);
    if (alignment & Qt::AlignTop) start.setY(metrics.ascent());
    if (alignment & Qt::AlignBottom) start.setY(-metrics.descent());
    if (alignment & Qt::AlignVCenter) start.setY(0.5 * metrics.capHeight());
    const bool turned = turned_deg != 0.0;
    if (turned) {
        painter.save();
        painter.translate(at);
        painter.rotate(turned_deg);
    } else {
        start += at;
    }
    painter.setFont(font);
    if (lettering.halo.alpha() > 0) {
        drawWithHalo(painter, start, metrics.ascent(), text, lettering);
    } else {
        painter.setPen(lettering.colour);
        painter.drawText(start, text);
    }
    if (turned) painter.restore();
}

void drawLines(QPainter& painter, const QRectF& box, Qt::Alignment side, const QStringList& lines,
               const Lettering& lettering) {
    const double high = lineHeight_px(lettering);
    const double x = side & Qt::AlignRight     ? box.right()
                     : side & Qt::AlignHCenter ? box.center().x()
                                               : box.left();
    for (qsizetype i = 0; i < lines.size(); ++i) {
        drawText(painter, {x, box.top() + (static_cast<double>(i) + 0.5) * high},
                 (side & Qt::AlignHorizontal_Mask) | Qt::AlignVCenter, lines[i], lettering);
    }
}

}  // namespace sagara::ui
