#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sagara::ui {

/// The database of this installation as its page sees it. Supplied by the station.
class DatabaseCare {
public:
    virtual ~DatabaseCare() = default;

    struct Facts {
        std::filesystem::path file;
        std::int64_t size_bytes = 0;
        int schemaVersion = 0;
        std::vector<std::pair<std::string, std::int64_t>> rows;  ///< by table
        std::string trouble;  ///< why there is no database; empty when there is
    };
    virtual Facts facts() const = 0;
    virtual bool runIsOn() const = 0;

    // These two may be called from any thread. The answer is what is wrong, one line each; empty: all is
    // well.
    virtual std::vector<std::string> checkIntegrity() const = 0;
    virtual std::vector<std::string> backupTo(const std::filesystem::path& copy) const = 0;
    /// Whether the file is a whole database that may be restored; from any thread.
    virtual std::vector<std::string> checkBackup(const std::filesystem::path& backup) const = 0;
    /// Puts a checked backup in place of the database, which is kept beside it. From the interface's thread.
    virtual std::optional<std::string> restore(const std::filesystem::path& backup) = 0;
    virtual std::filesystem::path keptCopy() const = 0;  ///< of the database before the last restore
};

}  // namespace sagara::ui
