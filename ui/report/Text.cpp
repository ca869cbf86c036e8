#include "ui/report/Text.h"

#include <QFont>
#include <QFontMetricsF>
#include <QPainterPath>
#include <QTextLayout>
#include <algorithm>
#include <cmath>

namespace sagara::report {
namespace {

/// Fonts come in whole pixels. A font pixel is a hundredth of a millimetre here, so sizes are as fine as one
/// likes.
constexpr double kFontPixel_mm = 0.01;
constexpr double kPoint_mm = 25.4 / 72.0;
/// The smallest letter spacing there is: it shows nowhere and keeps Qt from joining "fi", which a PDF could
/// not be searched for.
constexpr double kNoLigatures = 0.02;
constexpr QColor kHalo =
    colour::kPaper;  // opaque: a transparent pen makes Qt write every stroke as an outline
constexpr double kHalo_mm = 0.6;

QFont fontOf(const TextStyle& style) {
    QFont font;
    font.setFamilies(
        {QStringLiteral("Noto Sans"), QStringLiteral("DejaVu Sans"), QStringLiteral("Sans Serif")});
    font.setPixelSize(static_cast<int>(std::lround(style.size_pt * kPoint_mm / kFontPixel_mm)));
    font.setBold(style.bold);
    font.setItalic(style.italic);
    font.setHintingPreference(QFont::PreferNoHinting);
    font.setLetterSpacing(QFont::AbsoluteSpacing, kNoLigatures);
    return font;
}

QFontMetricsF metricsOf(const TextStyle& style) { return QFontMetricsF(fontOf(style)); }

double leftOf(double width, Qt::Alignment alignment) {
    if (alignment & Qt::AlignRight) return -width;
    return alignment & Qt::AlignHCenter ? -0.5 * width : 0.0;
}

/// From the point that is aligned down to the baseline.
double baselineOf(const QFontMetricsF& metrics, Qt::Alignment alignment) {
    if (alignment & Qt::AlignTop) return metrics.ascent();
    if (alignment & Qt::AlignBottom) return -metrics.descent();
    return alignment & Qt::AlignVCenter ? 0.5 * metrics.capHeight() : 0.0;
}

/// Turns the painter to font pixels about `at`; gives where the text begins there.
QPointF startOfText(QPainter& painter, QPointF at, Qt::Alignment alignment, const QString& text,
                    const TextStyle& style, double turned_deg) {
    const QFontMetricsF metrics = metricsOf(style);
    painter.translate(at);
    painter.rotate(turned_deg);
    painter.scale(kFontPixel_mm, kFontPixel_mm);
    return {leftOf(metrics.horizontalAdvance(text), alignment), baselineOf(metrics, alignment)};
}

/// Lines no wider than `width`, each as the text it holds. The last one holds all the rest.
QStringList broken(const QString& text, const QFont& font, double width, int mostLines) {
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    QTextLayout layout(text, font);
    layout.setTextOption(option);
    layout.beginLayout();
    QStringList lines;
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
        line.setLineWidth(width);
        const bool last = lines.size() + 1 == mostLines;
        lines.append(text.mid(line.textStart(), last ? -1 : line.textLength()).trimmed());
        if (last) break;
    }
    layout.endLayout();
    return lines;
}

}  // namespace

double width_mm(const QString& text, const TextStyle& style) {
    return kFontPixel_mm * metricsOf(style).horizontalAdvance(text);
}

double lineHeight_mm(const TextStyle& style) { return 1.3 * style.size_pt * kPoint_mm; }

double capHeight_mm(const TextStyle& style) { return kFontPixel_mm * metricsOf(style).capHeight(); }

QString elided(const QString& text, const TextStyle& style, double width_mm) {
    return metricsOf(style).elidedText(text, Qt::ElideRight, width_mm / kFontPixel_mm);
}

void drawText(QPainter& painter, QPointF at, Qt::Alignment alignment, const QString& text,
              const TextStyle& style, double turned_deg) {
    painter.save();
    painter.setFont(fontOf(style));
    painter.setPen(style.colour);
    painter.drawText(startOfText(painter, at, alignment, text, style, turned_deg), text);
    painter.restore();
}

void drawHaloText(QPainter& painter, QPointF at, Qt::Alignment alignment, const QString& text,
                  const TextStyle& style, double turned_deg) {
    painter.save();
    QPainterPath letters;
    letters.addText(startOfText(painter, at, alignment, text, style, turned_deg), fontOf(style), text);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(kHalo, kHalo_mm / kFontPixel_mm, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(letters);
    painter.restore();
    drawText(painter, at, alignment, text, style, turned_deg);
}

TextBlock::TextBlock(const QString& text, const TextStyle& style, double width_mm, int mostLines)
    : m_style(style), m_width_mm(width_mm) {
    for (const QString& paragraph : text.split(QLatin1Char('\n'))) {
        const int left = mostLines - static_cast<int>(m_lines.size());
        if (left <= 0) break;
        m_lines += broken(paragraph, fontOf(style), width_mm / kFontPixel_mm, left);
    }
    for (QString& line : m_lines) line = elided(line, style, width_mm);
}

double TextBlock::widest_mm() const {
    double widest = 0.0;
    for (const QString& line : m_lines) widest = std::max(widest, width_mm(line, m_style));
    return widest;
}

template <typename Draw>
void TextBlock::forEachLine(QPointF topLeft, Qt::Alignment alignment, Draw&& draw) const {
    const double shift_mm = alignment & Qt::AlignRight     ? m_width_mm
                            : alignment & Qt::AlignHCenter ? 0.5 * m_width_mm
                                                           : 0.0;
    const double line_mm = lineHeight_mm(m_style);
    for (qsizetype i = 0; i < m_lines.size(); ++i) {
        draw(topLeft + QPointF(shift_mm, (static_cast<double>(i) + 0.5) * line_mm),
             (alignment & Qt::AlignHorizontal_Mask) | Qt::AlignVCenter, m_lines[i]);
    }
}

void TextBlock::draw(QPainter& painter, QPointF topLeft, Qt::Alignment alignment) const {
    forEachLine(topLeft, alignment, [&](QPointF at, Qt::Alignment side, const QString& line) {
        drawText(painter, at, side, line, m_style);
    });
}

void TextBlock::drawWithHalo(QPainter& painter, QPointF topLeft, Qt::Alignment alignment) const {
    forEachLine(topLeft, alignment, [&](QPointF at, Qt::Alignment side, const QString& line) {
        drawHaloText(painter, at, side, line, m_style);
    });
}

}  // namespace sagara::report
