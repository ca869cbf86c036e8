#include "ui/settings/SettingsPage.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTimer>

#include "ui/settings/ControlsSection.h"
#include "ui/settings/DemoSection.h"
#include "ui/settings/DisplaySection.h"
#include "ui/settings/KeyboardSection.h"
#include "ui/settings/NmeaSection.h"
#include "ui/settings/SoundSection.h"
#include "ui/theme/Theme.h"

namespace sagara::ui {
namespace {

constexpr int kLive_ms = 33;

}  // namespace

SettingsPage::SettingsPage(std::unique_ptr<SettingsStore> store, BridgeInput& input, SoundBoard& sound,
                           std::function<void(PaletteName)> setPalette, const DataPlaces& places,
                           QWidget* parent)
    : Page(parent),
      m_store(std::move(store)),
      m_input(input),
      m_back(new QPushButton(tr("Back"), this)),
      m_list(new QListWidget(this)),
      m_stack(new QStackedWidget(this)),
      m_timer(new QTimer(this)) {
    m_back->setObjectName(QStringLiteral("back"));
    m_back->setToolTip(tr("Back to the page before. Everything is kept already."));
    m_list->setObjectName(QStringLiteral("sections"));
    m_list->setFixedWidth(210);
    m_list->setIconSize({24, 24});
    m_list->setSpacing(3);
    m_list->setToolTip(tr("Subjects; up and down keys"));
    auto* const title = new QLabel(tr("Settings"), this);
    QFont font = title->font();
    font.setPointSizeF(1.7 * font.pointSizeF());
    font.setBold(true);
    title->setFont(font);
    const QString trouble = m_store->trouble();
    auto* const kept =
        new QLabel(trouble.isEmpty() ? tr("What you change holds at once and is kept.")
                                     : tr("What you change holds until Sagara is closed: %1").arg(trouble),
                   this);
    kept->setObjectName(QStringLiteral("kept"));

    add(new DisplaySection(*m_store, std::move(setPalette), m_stack));
    add(new SoundSection(*m_store, sound, m_stack));
    add(new ControlsSection(*m_store, input, m_stack));
    add(new KeyboardSection(*m_store, input, m_stack));
    add(new NmeaSection(*m_store, input, m_stack));
    add(new DemoSection(*m_store, m_stack));
    add(new DataSection(places, m_stack));

    auto* const top = new QHBoxLayout;
    top->addWidget(m_back);
    top->addSpacing(12);
    top->addWidget(title);
    top->addStretch();
    top->addWidget(kept);
    auto* const middle = new QHBoxLayout;
    middle->setSpacing(16);
    middle->addWidget(m_list);
    middle->addWidget(m_stack, 1);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(24, 16, 24, 16);
    layout->setSpacing(12);
    layout->addLayout(top);
    layout->addLayout(middle, 1);

    connect(m_back, &QPushButton::clicked, this, &Page::leaveWanted);
    connect(m_list, &QListWidget::currentRowChanged, m_stack, &QStackedWidget::setCurrentIndex);
    connect(m_timer, &QTimer::timeout, this, [this] {
        if (isVisible()) m_sections[static_cast<std::size_t>(m_stack->currentIndex())]->refresh();
    });
    m_list->setCurrentRow(0);
    m_list->setFocus();
    m_timer->start(kLive_ms);
}

SettingsPage::~SettingsPage() {
    m_input.setPaused(false);
    // The sections look at the store, which goes before the widgets do.
    qDeleteAll(m_sections);
}

void SettingsPage::add(Section* section) {
    section->setMaximumWidth(1100);  // lines longer than this are not read
    auto* const scroll = new QScrollArea(m_stack);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    auto* const held = new QWidget;
    auto* const row = new QHBoxLayout(held);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(section, 100);
    row->addStretch(1);
    scroll->setWidget(held);
    m_stack->addWidget(scroll);
    m_list->addItem(section->title());
    m_sections.push_back(section);
}

// A ship that sails meanwhile must not obey a stick that is being calibrated.
void SettingsPage::showEvent(QShowEvent* event) {
    m_input.setPaused(true);
    Page::showEvent(event);
}

void SettingsPage::hideEvent(QHideEvent* event) {
    m_input.setPaused(false);
    Page::hideEvent(event);
}

void SettingsPage::openSection(int index) { m_list->setCurrentRow(index); }

void SettingsPage::setColours(PaletteName palette) {
    for (std::size_t i = 0; i < m_sections.size(); ++i) {
        m_sections[i]->setColours(palette);
        m_list->item(static_cast<int>(i))->setIcon(themedIcon(m_sections[i]->icon(), palette));
    }
}

QString SettingsPage::helpTopic() const {
    const int row = m_list->currentRow();
    return row >= 2 && row <= 4 ? QStringLiteral("input") : QStringLiteral("settings");
}

}  // namespace sagara::ui
