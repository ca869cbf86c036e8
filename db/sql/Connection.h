#pragma once

#include <QSqlDatabase>
#include <QString>
#include <chrono>
#include <filesystem>
#include <optional>
#include <thread>
#include <utility>

namespace sagara::db {

/// One open SQLite file under a connection name of its own, so that many live side by side in one process.
/// Belongs to the thread that made it. Opening touches no byte of the file; the first statement may.
class Connection final {
public:
    enum class Access { ReadOnly, ReadWrite, Create };

    Connection(const std::filesystem::path& file, Access access, std::chrono::milliseconds busyTimeout);
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    const std::filesystem::path& file() const { return m_file; }
    std::chrono::milliseconds busyTimeout() const { return m_busyTimeout; }
    /// Asserts that the caller is on the owning thread.
    const QSqlDatabase& handle() const;

    /// From now on `requireInPlace` compares with the file that is there at this moment.
    void noteFile();
    /// Throws DbError once the file noted is deleted, moved or replaced: SQLite would go on writing into what
    /// nobody can find any more.
    void requireInPlace() const;

    int openTransactions() const { return m_openTransactions; }
    void setOpenTransactions(int count) { m_openTransactions = count; }

private:
    using FileId = std::pair<std::uint64_t, std::uint64_t>;  ///< device and number on it
    std::optional<FileId> fileThere() const;

    std::filesystem::path m_file;
    std::chrono::milliseconds m_busyTimeout;
    std::thread::id m_owner = std::this_thread::get_id();
    QString m_name;
    QSqlDatabase m_handle;
    std::optional<FileId> m_noted;
    int m_openTransactions = 0;
};

}  // namespace sagara::db
