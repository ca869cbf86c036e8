#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "db/DbError.h"

namespace sagara::db {

class Connection;

inline constexpr std::chrono::milliseconds kBusyTimeout{5000};

struct TableCount {
    std::string table;
    std::int64_t rows = 0;
};

struct DatabaseInfo {
    std::filesystem::path file;
    std::int64_t size_bytes = 0;
    int schemaVersion = 0;
    std::vector<TableCount> counts;  ///< every table, by name
};

/// "sagara-version-1.db" beside "sagara.db".
std::filesystem::path olderCopy(const std::filesystem::path& file, int version);

/// The one SQLite file of this installation, open and of the current schema version. Every function may throw
/// DbError. Used by the thread that made it (asserted); another thread or process opens a Database of its
/// own. A QCoreApplication must exist. Not a place for SQL: that is in the repositories.
class Database {
public:
    enum class Existing { Refuse, Overwrite };

    /// Makes folder and file when missing and raises an older file to the current schema; a checked copy of
    /// the older one stays beside it (`olderCopy`). A file that is damaged, foreign or newer is refused and
    /// left as it is.
    explicit Database(const std::filesystem::path& file,
                      std::chrono::milliseconds busyTimeout = kBusyTimeout);
    ~Database();
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    DatabaseInfo info() const;

    /// What is wrong, one line each; empty when all is well. Reads every page and every document.
    std::vector<std::string> integrity() const;

    /// A checked copy, in one file, of the state at one instant; others may write meanwhile. `copy` appears
    /// whole or not at all. Not inside a Transaction.
    void backupTo(const std::filesystem::path& copy, Existing existing = Existing::Refuse) const;

    /// For the .cpp files of this folder.
    Connection& connection() const { return *m_connection; }

private:
    std::unique_ptr<Connection> m_connection;
};

}  // namespace sagara::db
