#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace sagara::db {

class Database;

/// What this installation remembers about itself, by key. All SQL about table `setting` is in this class's
/// .cpp file.
class SettingRepository final {
public:
    explicit SettingRepository(Database& db) : m_db(db) {}

    std::optional<std::string> find(std::string_view key) const;
    std::map<std::string, std::string> all() const;
    void put(std::string_view key, std::string_view value);
    void remove(std::string_view key);

private:
    Database& m_db;  ///< outlives every repository
};

}  // namespace sagara::db
