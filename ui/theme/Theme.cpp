#include "ui/theme/Theme.h"

#include <QApplication>
#include <QFile>
#include <QPainter>
#include <QPixmap>
#include <QStyleFactory>
#include <QSvgRenderer>

namespace sagara::ui {
namespace {

QPixmap drawn(QByteArray svg, const QColor& colour, int size_px) {
    svg.replace("currentColor", colour.name().toLatin1());
    QSvgRenderer renderer(svg);
    QPixmap picture(size_px, size_px);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    renderer.render(&painter);
    return picture;
}

/// The style draws edges darker than their ground, which black has no room for.
QString edgesAtNight(const ThemeColours& c) {
    return QStringLiteral(
               "QCheckBox::indicator { width: 12px; height: 12px; border: 1px solid %1; border-radius: 2px; }"
               "QCheckBox::indicator:checked { background: %2; }"
               "QCheckBox::indicator:focus { border-color: %3; }"
               "QLineEdit, QTextEdit, QPlainTextEdit, QAbstractItemView { border: 1px solid %1; }")
        .arg(c.border.name(), c.setValue.name(), c.text.name());
}

QString commonSheet(const ThemeColours& c) {
    return QStringLiteral(
               "QToolTip { color: %1; background: %2; border: 1px solid %3; padding: 3px; }"
               "QPushButton { min-height: 22px; padding: 3px 12px; border: 1px solid %3; border-radius: 4px;"
               " background: %2; }"
               "QPushButton:hover { border-color: %4; }"
               "QPushButton:pressed { background: %5; }"
               "QPushButton:checked, QPushButton[primary=\"true\"] { background: %6; color: %7;"
               " border-color: %6; }"
               "QPushButton:disabled { color: %8; background: %9; border-color: %5; }"
               "QPushButton:focus { border: 2px solid %4; padding: 2px 11px; }"
               "QGroupBox { font-weight: bold; border: 1px solid %3; border-radius: 4px; margin-top: 9px;"
               " padding-top: 6px; }"
               "QGroupBox::title { subcontrol-origin: margin; left: 8px; padding: 0 4px; }"
               "QHeaderView::section { background: %10; color: %1; border: none; padding: 4px 6px;"
               " border-bottom: 1px solid %3; }")
        .arg(c.text.name(), c.surface.name(), c.border.name(), c.focus.name(), c.pressed.name(),
             c.selected.name(), c.onSelected.name(), c.disabledText.name(), c.window.name())
        .arg(c.section.name());
}

}  // namespace

QPalette widgetPalette(PaletteName name) {
    const ThemeColours& c = themeColours(name);
    QPalette p;
    p.setColor(QPalette::Window, c.window);
    p.setColor(QPalette::WindowText, c.text);
    p.setColor(QPalette::Base, c.surface);
    p.setColor(QPalette::AlternateBase, c.section);
    p.setColor(QPalette::Text, c.text);
    p.setColor(QPalette::PlaceholderText, c.quietText);
    p.setColor(QPalette::Button, c.surface);
    p.setColor(QPalette::ButtonText, c.text);
    p.setColor(QPalette::BrightText, c.alarm);
    p.setColor(QPalette::Highlight, c.selected);
    p.setColor(QPalette::HighlightedText, c.onSelected);
    p.setColor(QPalette::ToolTipBase, c.surface);
    p.setColor(QPalette::ToolTipText, c.text);
    p.setColor(QPalette::Link, c.accent);
    p.setColor(QPalette::LinkVisited, c.accent);
    p.setColor(QPalette::Light, c.surface);
    p.setColor(QPalette::Midlight, c.section);
    p.setColor(QPalette::Mid, c.border);
    p.setColor(QPalette::Dark, c.border);
    p.setColor(QPalette::Shadow, c.border);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, c.disabledText);
    p.setColor(QPalette::Disabled, QPalette::Highlight, c.pressed);
    p.setColor(QPalette::Disabled, QPalette::HighlightedText, c.disabledText);
    return p;
}

QString styleSheet(PaletteName name) {
    const ThemeColours& c = themeColours(name);
    return name == PaletteName::Night ? commonSheet(c) + edgesAtNight(c) : commonSheet(c);
}

void applyTheme(QApplication& application, PaletteName name) {
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(widgetPalette(name));
    application.setStyleSheet(styleSheet(name));
}

QIcon themedIcon(const QString& icon, PaletteName palette) {
    QFile file(QStringLiteral(":/sagara/icons/%1.svg").arg(icon));
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QByteArray svg = file.readAll();
    const ThemeColours& c = themeColours(palette);
    QIcon made;
    for (const int size_px : {24, 48}) {
        made.addPixmap(drawn(svg, c.text, size_px), QIcon::Normal);
        made.addPixmap(drawn(svg, c.disabledText, size_px), QIcon::Disabled);
        made.addPixmap(drawn(svg, c.onSelected, size_px), QIcon::Selected);
    }
    return made;
}

}  // namespace sagara::ui
