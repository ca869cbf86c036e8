#include "db/SettingRepository.h"

#include "db/Database.h"
#include "db/sql/Query.h"

namespace sagara::db {

using namespace Qt::StringLiterals;

std::optional<std::string> SettingRepository::find(std::string_view key) const {
    Query row(m_db.connection(), u"SELECT value FROM setting WHERE key = ?"_s, key);
    if (!row.next()) return std::nullopt;
    return row.text(u"value"_s);
}

std::map<std::string, std::string> SettingRepository::all() const {
    Query row(m_db.connection(), u"SELECT key, value FROM setting"_s);
    std::map<std::string, std::string> settings;
    while (row.next()) settings[row.text(u"key"_s)] = row.text(u"value"_s);
    return settings;
}

void SettingRepository::put(std::string_view key, std::string_view value) {
    execute(
        m_db.connection(),
        u"INSERT INTO setting (key, value) VALUES (?, ?) ON CONFLICT (key) DO UPDATE SET value = excluded.value"_s,
        key, value);
}

void SettingRepository::remove(std::string_view key) {
    execute(m_db.connection(), u"DELETE FROM setting WHERE key = ?"_s, key);
}

}  // namespace sagara::db
