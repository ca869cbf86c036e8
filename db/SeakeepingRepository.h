#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace sagara::db {

class Database;

/// Seakeeping tables of hulls, as bytes under the hash of what they were made of: nothing that could not be
/// made again. All SQL about table `seakeeping` is in this class's .cpp file.
class SeakeepingRepository final {
public:
    explicit SeakeepingRepository(Database& db) : m_db(db) {}

    std::optional<std::string> find(std::uint64_t inputHash) const;
    /// The oldest beyond `kMost` go.
    void keep(std::uint64_t inputHash, std::string_view bytes);

    static constexpr int kMost = 40;  ///< about a megabyte each

private:
    Database& m_db;  ///< outlives every repository
};

}  // namespace sagara::db
