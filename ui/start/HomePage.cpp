#include "ui/start/HomePage.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/theme/Theme.h"

namespace sagara::ui {
namespace {

constexpr int kIcon_px = 48, kCardWidth_px = 200, kCardHeight_px = 380;

QLabel* words(const QString& text, double scale, bool bold, QWidget* parent) {
    auto* const label = new QLabel(text, parent);
    QFont font = label->font();
    font.setPointSizeF(scale * font.pointSizeF());
    font.setBold(bold);
    label->setFont(font);
    label->setWordWrap(true);
    return label;
}

}  // namespace

HomePage::HomePage(std::vector<Door> doors, QWidget* parent)
    : Page(parent), m_doors(std::move(doors)), m_notices(new QVBoxLayout) {
    setObjectName(QStringLiteral("home"));
    setWindowTitle(tr("Start"));
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(32, 16, 32, 16);
    layout->addWidget(words(tr("Sagara"), 3.0, true, this));
    layout->addWidget(words(tr("Ship-handling simulator"), 1.3, false, this));
    layout->addSpacing(8);
    layout->addLayout(m_notices);
    layout->addStretch(1);
    auto* const cards = new QHBoxLayout;
    cards->setSpacing(16);
    for (const Door& door : m_doors) cards->addWidget(card(door), 1);
    layout->addLayout(cards, 4);
    layout->addStretch(1);
    layout->addWidget(
        words(tr("There are no passwords yet: whoever sits here chooses a role. Training and "
                 "practice are kept apart from assessments; only an assessment counts as a grade."),
              1.0, false, this));
}

QWidget* HomePage::card(const Door& door) {
    auto* const card = new QFrame(this);
    card->setObjectName(QStringLiteral("card"));
    card->setMinimumWidth(kCardWidth_px);
    card->setMaximumHeight(kCardHeight_px);
    auto* const layout = new QVBoxLayout(card);
    layout->setContentsMargins(16, 16, 16, 16);
    layout->setSpacing(8);
    auto* const picture = new QLabel(card);
    picture->setFixedHeight(kIcon_px);
    m_pictures.push_back(picture);
    layout->addWidget(picture);
    layout->addWidget(words(door.name, 1.6, true, card));
    layout->addWidget(words(door.text, 1.0, false, card));
    layout->addStretch(1);
    bool first = true;
    for (const Room& room : door.rooms) {
        auto* const button = new QPushButton(room.name, card);
        button->setObjectName(room.objectName);
        button->setToolTip(room.tip);
        button->setMinimumHeight(first ? 40 : 32);
        if (std::exchange(first, false)) button->setProperty("primary", true);
        connect(button, &QPushButton::clicked, this, [enter = room.enter] { enter(); });
        layout->addWidget(button);
    }
    return card;
}

void HomePage::setColours(PaletteName name) {
    const ThemeColours& c = themeColours(name);
    setStyleSheet(
        QStringLiteral("QFrame#card { background: %1; border: 1px solid %2; border-radius: 8px; }"
                       "QFrame#notice { background: %1; border: 2px solid %3; border-radius: 4px; }")
            .arg(c.surface.name(), c.border.name(), c.accent.name()));
    for (std::size_t i = 0; i < m_doors.size(); ++i)
        m_pictures[i]->setPixmap(themedIcon(m_doors[i].icon, name).pixmap(kIcon_px, kIcon_px));
}

void HomePage::addNotice(const QString& text, std::vector<Room> ways) {
    auto* const notice = new QFrame(this);
    notice->setObjectName(QStringLiteral("notice"));
    auto* const layout = new QHBoxLayout(notice);
    auto* const label = words(text, 1.0, false, notice);
    label->setObjectName(QStringLiteral("notice-text"));
    layout->addWidget(label, 1);
    if (ways.empty()) ways.push_back({tr("Understood"), {}, QStringLiteral("notice-close"), [] {}});
    for (const Room& way : ways) {
        auto* const button = new QPushButton(way.name, notice);
        button->setObjectName(way.objectName);
        button->setToolTip(way.tip);
        connect(button, &QPushButton::clicked, notice, [notice, enter = way.enter] {
            notice->hide();
            notice->deleteLater();
            enter();
        });
        layout->addWidget(button);
    }
    m_notices->addWidget(notice);
}

}  // namespace sagara::ui
