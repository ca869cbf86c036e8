#include "ui/settings/DisplaySection.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/settings/StoredSettings.h"
#include "ui/theme/Theme.h"

namespace sagara::ui {
namespace {

constexpr std::array<PaletteName, 3> kPalettes{PaletteName::Day, PaletteName::Dusk, PaletteName::Night};
constexpr std::array<const char*, 3> kIcons{"palette-day", "palette-dusk", "palette-night"};

}  // namespace

DisplaySection::DisplaySection(SettingsStore& store, std::function<void(PaletteName)> setPalette,
                               QWidget* parent)
    : Section(tr("Display"), QStringLiteral("palette-dimming"), parent),
      m_store(store),
      m_setPalette(std::move(setPalette)) {
    const std::array<QString, 3> names{tr("Day"), tr("Dusk"), tr("Night")};
    const std::array<QString, 3> uses{tr("A lit classroom, or daylight on the bridge."),
                                      tr("Lights dimmed, the wall in front."),
                                      tr("A dark bridge: the screen must not spoil night vision.")};
    auto* const group = new QGroupBox(tr("Colours"), this);
    auto* const rows = new QGridLayout(group);
    auto* const one = new QButtonGroup(this);
    for (std::size_t i = 0; i < kPalettes.size(); ++i) {
        auto* const button = new QPushButton(names[i], group);
        button->setCheckable(true);
        button->setObjectName(QStringLiteral("palette-%1").arg(i));
        button->setToolTip(uses[i]);
        button->setMinimumSize(130, 40);
        button->setIconSize({24, 24});
        one->addButton(button);
        rows->addWidget(button, static_cast<int>(i), 0);
        rows->addWidget(note(uses[i]), static_cast<int>(i), 1);
        const PaletteName palette = kPalettes[i];
        connect(button, &QPushButton::clicked, this, [this, palette] { choose(palette); });
        m_choices[i] = button;
    }
    rows->setColumnStretch(1, 1);
    rows->setHorizontalSpacing(16);
    auto* const language = new QGroupBox(tr("Language"), this);
    (new QVBoxLayout(language))->addWidget(note(tr("English. No other language is installed.")));
    auto* const layout = new QVBoxLayout(this);
    layout->addWidget(group);
    layout->addWidget(sizeGroup());
    layout->addWidget(language);
    layout->addStretch();
}

QWidget* DisplaySection::sizeGroup() {
    auto* const group = new QGroupBox(tr("Size of text and controls"), this);
    auto* const sizes = new QComboBox(group);
    sizes->setObjectName(QStringLiteral("size"));
    sizes->setToolTip(tr("In percent of the usual size"));
    sizes->addItem(tr("As the monitor asks for"));
    for (const int percent : kSizes_percent) sizes->addItem(tr("%1 %").arg(percent), percent);
    const auto stored = storedSize_percent(m_store);
    sizes->setCurrentIndex(stored ? sizes->findData(*stored) : 0);
    connect(sizes, &QComboBox::activated, this, [this, sizes] {
        const QVariant chosen = sizes->currentData();
        storeSize_percent(m_store, chosen.isValid() ? std::optional(chosen.toInt()) : std::nullopt);
    });
    auto* const row = new QHBoxLayout(group);
    row->addWidget(sizes);
    row->addWidget(note(tr("Holds from the next start of Sagara on.")), 1);
    row->setSpacing(16);
    return group;
}

void DisplaySection::choose(PaletteName palette) {
    storePalette(m_store, palette);
    m_setPalette(palette);
}

void DisplaySection::setColours(PaletteName palette) {
    Section::setColours(palette);
    for (std::size_t i = 0; i < kPalettes.size(); ++i) {
        const bool chosen = kPalettes[i] == palette;
        m_choices[i]->setChecked(chosen);
        // On a chosen button the icon stands on the colour of selection.
        const QIcon icon = themedIcon(QString::fromLatin1(kIcons[i]), palette);
        m_choices[i]->setIcon(chosen ? QIcon(icon.pixmap(48, 48, QIcon::Selected)) : icon);
    }
}

}  // namespace sagara::ui
