#include "ui/roster/Field.h"

#include <QPainter>

namespace sagara::ui::roster {

FieldNote::FieldNote(QWidget* parent) : QLabel(parent) {
    setWordWrap(true);
    setIndent(10);
    hide();
}

void FieldNote::say(const QString& fault) {
    setText(fault);
    setVisible(!fault.isEmpty());
}

/// A bar at its side marks it as a fault: not by colour alone, and in any palette.
void FieldNote::paintEvent(QPaintEvent* event) {
    QLabel::paintEvent(event);
    QPainter painter(this);
    painter.fillRect(QRect(0, 1, 3, height() - 2), palette().color(QPalette::BrightText));
}

QLabel* heading(const QString& text, double scale, QWidget* parent) {
    auto* const label = new QLabel(text, parent);
    QFont font = label->font();
    font.setPointSizeF(scale * font.pointSizeF());
    font.setBold(true);
    label->setFont(font);
    return label;
}

QLabel* hint(const QString& text, QWidget* parent) {
    auto* const label = new QLabel(text, parent);
    label->setWordWrap(true);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

}  // namespace sagara::ui::roster
