#include "app/station/SettingsDoor.h"

#include "app/station/Frame.h"
#include "db/SettingRepository.h"
#include "ui/settings/SettingsPage.h"

namespace sagara::station {
namespace {

QString shown(const std::filesystem::path& path) { return QString::fromStdString(path.string()); }

/// In the database. What it cannot take (locked, full, gone) is kept in memory and said.
class DatabaseSettings final : public ui::SettingsStore {
public:
    explicit DatabaseSettings(db::Database& database) : m_settings(database) {}

    std::optional<std::string> get(std::string_view key) const override {
        if (auto kept = m_memory.get(key)) return kept;
        try {
            return m_settings.find(key);
        } catch (const db::DbError&) {
            return std::nullopt;
        }
    }
    void put(std::string_view key, std::string_view value) override {
        try {
            m_settings.put(key, value);
        } catch (const db::DbError& e) {
            m_trouble = QString::fromUtf8(e.what());
            m_memory.put(key, value);
        }
    }
    QString trouble() const override { return m_trouble; }

private:
    db::SettingRepository m_settings;
    ui::MemorySettings m_memory;
    QString m_trouble;
};

}  // namespace

std::unique_ptr<ui::SettingsStore> settingsStore(run::Store& store) {
    if (store.database() != nullptr) return std::make_unique<DatabaseSettings>(*store.database());
    const QString why = QString::fromStdString(store.trouble());
    return std::make_unique<ui::MemorySettings>(why.isEmpty() ? ui::SettingsPage::tr("there is no database")
                                                              : why);
}

std::unique_ptr<ui::SettingsStore> settingsStore(Frame& frame) { return settingsStore(frame.store()); }

ui::Page* settingsPage(Frame& frame, ui::BridgeInput& input, ui::SoundBoard& sound,
                       std::function<void(ui::PaletteName)> setPalette) {
    const db::DataFolder& folder = frame.store().folder();
    const ui::DataPlaces places{shown(folder.root()), shown(folder.database()),
                                QString::fromStdString(frame.store().trouble()), shown(folder.recordings())};
    auto* const page =
        new ui::SettingsPage(settingsStore(frame), input, sound, std::move(setPalette), places);
    page->setColours(frame.colours());
    return page;
}

}  // namespace sagara::station
