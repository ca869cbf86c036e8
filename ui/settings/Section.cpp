#include "ui/settings/Section.h"

#include "ui/theme/ThemeColours.h"

namespace sagara::ui {
namespace {

void colour(QLabel* label, const QColor& words) {
    QPalette p = label->palette();
    p.setColor(QPalette::WindowText, words);
    label->setPalette(p);
}

}  // namespace

Section::Section(const QString& title, const QString& icon, QWidget* parent)
    : QWidget(parent), m_title(title), m_icon(icon) {}

void Section::setColours(PaletteName palette) {
    m_paletteName = palette;
    const ThemeColours& c = themeColours(palette);
    // Words of alarms are seldom readable on the window: the accent of ports and the like is.
    for (const auto& label : m_complaints)
        if (label) colour(label, c.port);
    m_notes.removeIf([](const auto& label) { return label.isNull(); });
    for (const auto& label : m_notes) colour(label, c.quietText);
}

QLabel* Section::note(const QString& text) {
    auto* const label = new QLabel(text, this);
    label->setWordWrap(true);
    m_notes.append(label);
    return label;
}

QLabel* Section::complaint(const char* name) {
    auto* const label = new QLabel(this);
    label->setObjectName(QString::fromLatin1(name));
    label->setWordWrap(true);
    label->hide();
    m_complaints.append(label);
    return label;
}

void Section::say(QLabel* complaint, const QString& text) {
    if (complaint->text() == text) return;
    complaint->setText(text);
    complaint->setVisible(!text.isEmpty());
}

}  // namespace sagara::ui
