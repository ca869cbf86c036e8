#include "ui/demo/PinPad.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "ui/theme/ThemeColours.h"

namespace sagara::ui {

PinPad::PinPad(DemoLock& lock, QWidget* parent)
    : QWidget(parent),
      m_lock(lock),
      m_title(new QLabel(tr("PIN to leave the exhibition"), this)),
      m_dots(new QLabel(this)),
      m_message(new QLabel(this)) {
    setObjectName(QStringLiteral("pin-pad"));
    setFocusPolicy(Qt::StrongFocus);
    m_dots->setObjectName(QStringLiteral("pin-dots"));
    m_message->setObjectName(QStringLiteral("pin-message"));
    auto* const layout = new QVBoxLayout(this);
    for (QLabel* label : {m_title, m_dots, m_message}) {
        label->setAlignment(Qt::AlignCenter);
        layout->addWidget(label);
    }
    auto* const grid = new QGridLayout;
    layout->addLayout(grid, 1);
    const auto button = [&](const QString& text, const QString& name, int row, int column) {
        auto* const made = new QPushButton(text, this);
        made->setObjectName(name);
        made->setFocusPolicy(Qt::NoFocus);
        made->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
        grid->addWidget(made, row, column);
        return made;
    };
    for (int digit = 0; digit <= 9; ++digit) {
        const int row = digit == 0 ? 3 : (digit - 1) / 3, column = digit == 0 ? 1 : (digit - 1) % 3;
        m_digits.push_back(button(QString::number(digit), QStringLiteral("pin-%1").arg(digit), row, column));
        connect(m_digits.back(), &QPushButton::clicked, this,
                [this, digit] { type(static_cast<char>('0' + digit)); });
    }
    connect(button(tr("Cancel"), QStringLiteral("pin-cancel"), 3, 0), &QPushButton::clicked, this,
            &PinPad::cancel);
    connect(button(tr("Erase"), QStringLiteral("pin-erase"), 3, 2), &QPushButton::clicked, this, [this] {
        m_lock.erase();
        refresh();
    });
    hide();
}

void PinPad::open() {
    m_lock.open();
    refresh();
    show();
    raise();
    setFocus();
}

void PinPad::cancel() {
    m_lock.close();
    hide();
    if (parentWidget() != nullptr) parentWidget()->setFocus();
}

void PinPad::advance(double elapsed_s) {
    m_lock.advance(elapsed_s);
    if (!isVisible()) return;
    if (!m_lock.isOpen()) return cancel();
    refresh();
}

void PinPad::type(char digit) {
    const bool right = m_lock.type(digit);
    refresh();
    if (!right) return;
    cancel();
    Q_EMIT opened();
}

void PinPad::refresh() {
    QString dots;
    for (std::size_t i = 0; i < m_lock.digits(); ++i)
        dots += i < m_lock.typed() ? QStringLiteral("● ") : QStringLiteral("○ ");
    m_dots->setText(dots.trimmed());
    const double wait_s = m_lock.waits_s();
    m_message->setText(wait_s > 0.0        ? tr("Wrong PIN. Again in %1 s.").arg(std::ceil(wait_s), 0, 'f', 0)
                       : m_lock.wasWrong() ? tr("Try again.")
                                           : tr("%1 digits").arg(m_lock.digits()));
    for (QPushButton* digit : m_digits) digit->setEnabled(wait_s == 0.0);
}

void PinPad::fit(QSize page, PaletteName palette) {
    m_palette = palette;
    const int height = std::max(320, page.height() * 6 / 10), width = height * 3 / 4;
    setGeometry((page.width() - width) / 2, (page.height() - height) / 2, width, height);
    const ThemeColours& c = themeColours(palette);
    setStyleSheet(
        QStringLiteral("QLabel { color: %1; font-size: %2px; }"
                       "QPushButton { color: %1; background: %3; border: 1px solid %4; font-size: %5px;"
                       " border-radius: 8px; padding: 0; }"
                       "QPushButton:pressed { background: %6; }"
                       "QPushButton:disabled { color: %7; }")
            .arg(c.text.name())
            .arg(height / 22)
            .arg(c.section.name(), c.border.name())
            .arg(height / 20)
            .arg(c.pressed.name(), c.disabledText.name()));
    layout()->setContentsMargins(height / 20, height / 20, height / 20, height / 20);
    layout()->setSpacing(height / 60);
}

void PinPad::keyPressEvent(QKeyEvent* event) {
    const int key = event->key();
    if (key >= Qt::Key_0 && key <= Qt::Key_9) return type(static_cast<char>('0' + key - Qt::Key_0));
    if (key == Qt::Key_Escape) return cancel();
    if (key == Qt::Key_Backspace) {
        m_lock.erase();
        refresh();
    }
}

void PinPad::mousePressEvent(QMouseEvent* event) { event->accept(); }

void PinPad::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ThemeColours& c = themeColours(m_palette);
    painter.setPen(QPen(c.border, 2.0));
    painter.setBrush(c.surface);
    painter.drawRoundedRect(rect().adjusted(1, 1, -1, -1), 14.0, 14.0);
}

}  // namespace sagara::ui
