#include "db/sql/Connection.h"

#include <sys/stat.h>

#include <QSqlError>
#include <QUrl>
#include <atomic>
#include <cassert>

#include "db/sql/Failure.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;

QString uniqueName() {
    static std::atomic<unsigned> count{0};
    return u"sagara-db-%1"_s.arg(++count);
}

QString modeOf(Connection::Access access) {
    switch (access) {
        case Connection::Access::ReadOnly:
            return u"?mode=ro"_s;
        case Connection::Access::ReadWrite:
            return u"?mode=rw"_s;  // unlike SQLite's default, makes no file
        case Connection::Access::Create:
            break;
    }
    return u"?mode=rwc"_s;
}

QString uriOf(const std::filesystem::path& file, Connection::Access access) {
    const QUrl url = QUrl::fromLocalFile(QString::fromStdString(file.string()));
    return QString::fromLatin1(url.toEncoded(QUrl::FullyEncoded)) + modeOf(access);
}

}  // namespace

Connection::Connection(const std::filesystem::path& file, Access access,
                       std::chrono::milliseconds busyTimeout)
    : m_file(std::filesystem::absolute(file).lexically_normal()),
      m_busyTimeout(busyTimeout),
      m_name(uniqueName()) {
    m_handle = QSqlDatabase::addDatabase(u"QSQLITE"_s, m_name);
    m_handle.setDatabaseName(uriOf(m_file, access));
    m_handle.setConnectOptions(u"QSQLITE_OPEN_URI;QSQLITE_BUSY_TIMEOUT=%1"_s.arg(busyTimeout.count()));
    if (m_handle.open()) return;
    const QSqlError error = m_handle.lastError();
    m_handle = QSqlDatabase();
    QSqlDatabase::removeDatabase(m_name);
    throw failure(*this, error);
}

Connection::~Connection() {
    assert(std::this_thread::get_id() == m_owner);
    m_handle.close();
    m_handle = QSqlDatabase();
    QSqlDatabase::removeDatabase(m_name);
}

const QSqlDatabase& Connection::handle() const {
    assert(std::this_thread::get_id() == m_owner && "a Database is used by the thread that made it");
    return m_handle;
}

std::optional<Connection::FileId> Connection::fileThere() const {
    struct stat found {};
    if (::stat(m_file.c_str(), &found) != 0) return std::nullopt;
    return FileId{found.st_dev, found.st_ino};
}

void Connection::noteFile() { m_noted = fileThere(); }

void Connection::requireInPlace() const {
    if (!m_noted || fileThere() == m_noted) return;
    throw problem(
        DbError::Kind::CannotOpen, m_file,
        "was deleted, moved or replaced while Sagara had it open. Put it back and start Sagara again; "
        "runs sailed meanwhile are kept as recordings and filed then");
}

}  // namespace sagara::db
