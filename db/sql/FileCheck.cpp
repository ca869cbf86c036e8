#include "db/sql/FileCheck.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

#include "db/schema/Schema.h"
#include "db/sql/Failure.h"
#include "db/sql/Migrate.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;
using Kind = DbError::Kind;
constexpr std::uintmax_t kSmallestPage_bytes = 512;  // https://www.sqlite.org/fileformat.html, section 1.3.2

std::int64_t pragma(Connection& connection, const QString& name) {
    Query row(connection, u"PRAGMA "_s + name);
    row.next();
    return row.integer(name);
}

void requireOurApplication(Connection& connection) {
    const std::int64_t id = pragma(connection, u"application_id"_s);
    if (id == kApplicationId) return;
    throw problem(Kind::Foreign, connection.file(),
                  "belongs to another application (application id " + std::to_string(id) +
                      "), expected a database of Sagara (" + std::to_string(kApplicationId) + ")");
}

void requireKnownVersion(Connection& connection) {
    const int version = schemaVersion(connection);
    const std::string found = "has schema version " + std::to_string(version) + ", this program reads 1 to " +
                              std::to_string(kSchemaVersion);
    if (version > kSchemaVersion) {
        throw problem(Kind::Newer, connection.file(), "was written by a newer Sagara: " + found);
    }
    // A file takes its name only when it has version 1: NewFile.h.
    if (version < 1) throw problem(Kind::Damaged, connection.file(), found);
}

void requireFile(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size_bytes = std::filesystem::file_size(file, error);
    if (error) throw problem(Kind::CannotOpen, file, "is no file that can be read: " + error.message());
    if (size_bytes >= kSmallestPage_bytes) return;  // less may be a healthy, empty database to SQLite
    throw problem(Kind::Damaged, file,
                  "holds " + std::to_string(size_bytes) + " bytes, expected a database of Sagara");
}

/// Committed pages wait beside the file until they are moved into it.
bool hasLog(const std::filesystem::path& file) {
    std::error_code none;
    const auto log_bytes = std::filesystem::file_size(file.string() + "-wal", none);
    return !none && log_bytes > 0;
}

/// Closing the last writing connection would move what a crashed program left in its log into the file.
Connection::Access accessThatChangesNothing(const std::filesystem::path& file) {
    return hasLog(file) ? Connection::Access::ReadOnly : Connection::Access::ReadWrite;
}

void requireWhole(Connection& connection) {
    const std::vector<std::string> faults = faultsFound(connection, false);
    if (!faults.empty()) throw problem(Kind::Damaged, connection.file(), "is damaged: " + faults.front());
    const auto page_bytes = static_cast<std::uintmax_t>(pragma(connection, u"page_size"_s));
    // SQLite takes a cut within the last page for zeros. With a log the file may be in the middle of growing.
    if (hasLog(connection.file()) || std::filesystem::file_size(connection.file()) % page_bytes == 0) return;
    throw problem(Kind::Damaged, connection.file(), "is damaged: it ends in the middle of a page");
}

}  // namespace

void requireWritable(const std::filesystem::path& file) {
    for (const std::filesystem::path& path : {file, file.parent_path()}) {
        // By the effective user, unlike access(2); says no on a read-only disk, too.
        if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0 || errno == ENOENT) continue;
        throw problem(Kind::ReadOnly, path, "may not be written");
    }
}

void requireOurs(const std::filesystem::path& file, std::chrono::milliseconds busyTimeout) {
    requireFile(file);
    requireWritable(file);
    Connection probe(file, accessThatChangesNothing(file), busyTimeout);
    requireOurApplication(probe);
    requireKnownVersion(probe);
    requireWhole(probe);
}

std::vector<std::string> faultsFound(Connection& connection, bool thorough) {
    std::vector<std::string> faults;
    Query row(connection, thorough ? u"PRAGMA integrity_check"_s : u"PRAGMA quick_check(1)"_s);
    const QString column = thorough ? u"integrity_check"_s : u"quick_check"_s;
    while (row.next()) faults.push_back(row.text(column));
    if (faults.size() == 1 && faults.front() == "ok") faults.clear();
    return faults;
}

}  // namespace sagara::db
