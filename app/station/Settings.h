#pragma once

#include <map>
#include <optional>
#include <string>

#include "app/run/Store.h"

namespace sagara::station {

/// What the station remembers from one start to the next: in the database, and where that cannot be used,
/// until it is closed.
class Settings {
public:
    explicit Settings(run::Store& store) : m_store(store) {}

    std::optional<std::string> get(const std::string& key) const;
    void put(const std::string& key, const std::string& value);

private:
    run::Store& m_store;
    std::map<std::string, std::string> m_unkept;
};

}  // namespace sagara::station
