#pragma once

#include <QColor>
#include <QCoreApplication>
#include <QFont>
#include <QPainter>
#include <QString>
#include <QStringList>

/// Words on the chart, in logical pixels.
namespace sagara::ui {

/// Text a person reads, outside of a QObject.
inline QString tr(const char* text) { return QCoreApplication::translate("sagara::ui", text); }

struct Lettering {
    double size_px = 12.0;
    QColor colour;
    QColor halo{0, 0, 0, 0};  ///< transparent: none
    bool bold = false;
    bool italic = false;
};

QFont fontOf(const Lettering& lettering);
double textWidth_px(const QString& text, const Lettering& lettering);
double lineHeight_px(const Lettering& lettering);
/// Of all the lines.
QSizeF textSize_px(const QStringList& lines, const Lettering& lettering);
QString elided(const QString& text, const Lettering& lettering, double width_px);

/// One line. `at` is the side, centre or corner that `alignment` names; AlignVCenter centres capitals and
/// figures. Turned clockwise about `at`.
void drawText(QPainter& painter, QPointF at, Qt::Alignment alignment, const QString& text,
              const Lettering& lettering, double turned_deg = 0.0);
/// Lines in a box of textSize_px, each aligned to a side of it.
void drawLines(QPainter& painter, const QRectF& box, Qt::Alignment side, const QStringList& lines,
               const Lettering& lettering);

}  // namespace sagara::ui
