#pragma once

#include <filesystem>

#include "core/seakeeping/TableCache.h"

namespace sagara::run {

/// Seakeeping tables kept in the school's database. From any thread: each call opens the file for itself. A
/// database that is gone, locked or full costs nothing but the time to make the tables again.
class DatabaseTables final : public core::TableCache {
public:
    explicit DatabaseTables(std::filesystem::path database) : m_database(std::move(database)) {}
    std::optional<core::SeakeepingTables> find(std::uint64_t inputHash) override;
    void keep(const core::SeakeepingTables& tables) override;

private:
    std::filesystem::path m_database;
};

}  // namespace sagara::run
