#pragma once

#include <QCoreApplication>
#include <QPainter>
#include <QString>
#include <QStringList>
#include <string>

#include "ui/report/Style.h"

/// Text on a page. Everything is in millimetres, except the size of letters, which printers count in points.
namespace sagara::report {

struct TextStyle {
    double size_pt = 9.0;
    QColor colour = colour::kInk;
    bool bold = false;
    bool italic = false;
};

/// Text a person reads, translated when a translation is loaded.
inline QString tr(const char* text) { return QCoreApplication::translate("sagara::report", text); }
inline QString fromStd(const std::string& utf8) { return QString::fromStdString(utf8); }

double width_mm(const QString& text, const TextStyle& style);
double lineHeight_mm(const TextStyle& style);
/// Height of a capital letter or figure: what labels are centred on.
double capHeight_mm(const TextStyle& style);
QString elided(const QString& text, const TextStyle& style, double width_mm);

/// One line. `at` is the side, centre or corner of the text that `alignment` names; AlignBaseline is the
/// default in the vertical, AlignVCenter centres capitals and figures. Turned clockwise about `at`.
void drawText(QPainter& painter, QPointF at, Qt::Alignment alignment, const QString& text,
              const TextStyle& style, double turned_deg = 0.0);

/// The same with a margin of paper colour round the letters, to be read over lines and areas.
void drawHaloText(QPainter& painter, QPointF at, Qt::Alignment alignment, const QString& text,
                  const TextStyle& style, double turned_deg = 0.0);

/// Text broken into lines that fit a width; a last line with more to say ends in an ellipsis.
class TextBlock {
public:
    TextBlock() = default;
    TextBlock(const QString& text, const TextStyle& style, double width_mm, int mostLines = 40);
    double height_mm() const { return lineHeight_mm(m_style) * static_cast<double>(m_lines.size()); }
    double widest_mm() const;
    /// `alignment`: left, right or centred in the block's width.
    void draw(QPainter& painter, QPointF topLeft, Qt::Alignment alignment = Qt::AlignLeft) const;
    void drawWithHalo(QPainter& painter, QPointF topLeft, Qt::Alignment alignment = Qt::AlignLeft) const;

private:
    template <typename Draw>
    void forEachLine(QPointF topLeft, Qt::Alignment alignment, Draw&& draw) const;

    QStringList m_lines;
    TextStyle m_style;
    double m_width_mm = 0.0;
};

}  // namespace sagara::report
