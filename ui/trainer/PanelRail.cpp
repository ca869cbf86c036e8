#include "ui/trainer/PanelRail.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QShortcut>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/theme/Theme.h"

namespace sagara::ui {
namespace {

constexpr int kTab_px = 66, kIcon_px = 24, kPanelLeast_px = 318;

}  // namespace

PanelRail::PanelRail(QWidget* parent)
    : QWidget(parent),
      m_column(new QVBoxLayout),
      m_buttons(new QButtonGroup(this)),
      m_stack(new QStackedWidget(this)) {
    auto* const layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    m_column->setContentsMargins(2, 4, 2, 4);
    m_column->setSpacing(2);
    m_column->addStretch();
    layout->addLayout(m_column);
    layout->addWidget(m_stack, 1);
    m_stack->setMinimumWidth(kPanelLeast_px);
    m_buttons->setExclusive(true);
    connect(m_buttons, &QButtonGroup::idClicked, m_stack, &QStackedWidget::setCurrentIndex);
}

void PanelRail::add(const QString& name, const QString& title, const QString& icon, QWidget* panel,
                    bool scrolls) {
    const int index = static_cast<int>(m_tabs.size());
    auto* const button = new QToolButton(this);
    button->setObjectName(QStringLiteral("tab-") + name);
    button->setText(title);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIconSize({kIcon_px, kIcon_px});
    button->setFixedSize(kTab_px, 54);
    button->setCheckable(true);
    button->setAutoRaise(true);
    QFont small = button->font();
    small.setPointSizeF(0.86 * small.pointSizeF());
    button->setFont(small);
    button->setToolTip(tr("%1 (Ctrl+%2)").arg(title).arg(index + 1));
    m_buttons->addButton(button, index);
    m_column->insertWidget(index, button);
    m_tabs.push_back({name, icon, button});
    QWidget* page = panel;
    if (scrolls) {
        auto* const area = new QScrollArea(m_stack);
        area->setWidget(panel);
        area->setWidgetResizable(true);
        area->setFrameShape(QFrame::NoFrame);
        area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        page = area;
    }
    m_stack->addWidget(page);
    if (index < 9) {
        auto* const key =
            new QShortcut(QKeySequence(Qt::CTRL | static_cast<Qt::Key>(Qt::Key_1 + index)), this);
        connect(key, &QShortcut::activated, this, [this, name] { showPanel(name); });
    }
    if (index == 0) button->setChecked(true);
}

void PanelRail::showPanel(const QString& name) {
    for (std::size_t i = 0; i < m_tabs.size(); ++i) {
        if (m_tabs[i].name != name) continue;
        m_tabs[i].button->setChecked(true);
        m_stack->setCurrentIndex(static_cast<int>(i));
    }
}

QString PanelRail::shown() const {
    const auto i = static_cast<std::size_t>(std::max(0, m_stack->currentIndex()));
    return i < m_tabs.size() ? m_tabs[i].name : QString();
}

void PanelRail::setColours(PaletteName name) {
    for (const Tab& tab : m_tabs) tab.button->setIcon(themedIcon(tab.icon, name));
}

}  // namespace sagara::ui
