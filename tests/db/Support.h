#pragma once

#include <QString>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "core/base/Utc.h"
#include "db/Database.h"
#include "db/DocumentRepository.h"
#include "db/FileRun.h"

namespace sagara::db::test {

/// A folder of its own, gone with the object.
class TemporaryFolder final {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return m_path; }
    std::filesystem::path operator/(std::string_view name) const { return m_path / name; }

private:
    std::filesystem::path m_path;
};

/// Only while no connection of this process has the file open: closing it drops SQLite's locks.
std::string readBytes(const std::filesystem::path& file);
void writeBytes(const std::filesystem::path& file, std::string_view bytes);

/// Every file of a folder with its bytes, but for SQLite's shared memory (-shm), which holds no data.
std::map<std::string, std::string> contentsOf(const std::filesystem::path& folder);

/// Runs one statement through a connection of its own; makes the file when missing.
void executeIn(const std::filesystem::path& file, const QString& sql);

/// Runs statements that end with a semicolon at the end of a line, as the samples are written.
void executeScript(const std::filesystem::path& file, const std::filesystem::path& script);

/// The DbError that `action` throws; fails the test when there is none.
DbError errorOf(const std::function<void()>& action);

/// The same in a child process, which root leaves for an ordinary user first: nothing is read-only to root.
/// The text is "KIND what()" with KIND as a number, or "none".
std::string errorAsOrdinaryUser(const std::function<void()>& action);
std::string kindPrefix(DbError::Kind kind);

inline constexpr core::Utc kMorning{1800000000};  // 2027-01-15T08:00:00Z
inline constexpr core::Utc kNoon{1800014400};

NewDocument patrol(std::string text = R"({"id": "patrol51"})");
NewRun lesson(std::string recordingFile = "recordings/a.sagarec");
RunResult ended();
Grade good();

}  // namespace sagara::db::test
