#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "ui/input/BridgeInput.h"
#include "ui/settings/DataSection.h"
#include "ui/settings/SettingsStore.h"
#include "ui/sound/SoundBoard.h"
#include "ui/theme/Page.h"

class QListWidget;
class QPushButton;
class QStackedWidget;
class QTimer;

namespace sagara::ui {

class Section;

/// Everything a person may set, by subject. What is changed holds at once and is kept at once.
class SettingsPage final : public Page {
    Q_OBJECT

public:
    /// `input` and `sound` outlive the page.
    SettingsPage(std::unique_ptr<SettingsStore> store, BridgeInput& input, SoundBoard& sound,
                 std::function<void(PaletteName)> setPalette, const DataPlaces& places,
                 QWidget* parent = nullptr);
    ~SettingsPage() override;

    void setColours(PaletteName palette) override;
    QString helpTopic() const override;
    void openSection(int index);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void add(Section* section);
    std::unique_ptr<SettingsStore> m_store;
    BridgeInput& m_input;
    QPushButton* m_back;
    QListWidget* m_list;
    QStackedWidget* m_stack;
    std::vector<Section*> m_sections;
    QTimer* m_timer;
};

}  // namespace sagara::ui
