#include "app/station/Settings.h"

#include "db/SettingRepository.h"

namespace sagara::station {

std::optional<std::string> Settings::get(const std::string& key) const {
    if (const auto found = m_unkept.find(key); found != m_unkept.end()) return found->second;
    if (m_store.database() == nullptr) return std::nullopt;
    try {
        return db::SettingRepository(*m_store.database()).find(key);
    } catch (const db::DbError&) {
        return std::nullopt;
    }
}

void Settings::put(const std::string& key, const std::string& value) {
    try {
        if (m_store.database() != nullptr) {
            db::SettingRepository(*m_store.database()).put(key, value);
            m_unkept.erase(key);
            return;
        }
    } catch (const db::DbError&) {
        // Kept below: a setting is not worth a message.
    }
    m_unkept[key] = value;
}

}  // namespace sagara::station
