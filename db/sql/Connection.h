#pragma once

#include <QSqlDatabase>
#include <QString>
#include <chrono>
#include <filesystem>
#include <thread>

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

    int openTransactions() const { return m_openTransactions; }
    void setOpenTransactions(int count) { m_openTransactions = count; }

private:
    std::filesystem::path m_file;
    std::chrono::milliseconds m_busyTimeout;
    std::thread::id m_owner = std::this_thread::get_id();
    QString m_name;
    QSqlDatabase m_handle;
    int m_openTransactions = 0;
};

}  // namespace sagara::db
