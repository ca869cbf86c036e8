#include "db/sql/Failure.h"

#include <sstream>

#include "db/sql/Connection.h"

namespace sagara::db {
namespace {

using Kind = DbError::Kind;
constexpr int kDiskTrouble = 10;  // IOERR; also a quota or size limit that is used up
constexpr int kNotADatabase = 26;

std::string seconds(std::chrono::milliseconds time) {
    std::ostringstream text;
    text << static_cast<double>(time.count()) / 1000.0 << " s";
    return text.str();
}

std::string found(int sqliteCode, const Connection& connection) {
    if ((sqliteCode & 0xff) == kDiskTrouble) return "the disk could not be read or written";
    if ((sqliteCode & 0xff) == kNotADatabase) return "this is not a database, or its beginning is damaged";
    switch (kindOf(sqliteCode)) {
        case Kind::CannotOpen:
            return "the database cannot be opened";
        case Kind::Locked:
            return "another program kept the database locked for " + seconds(connection.busyTimeout());
        case Kind::ReadOnly:
            return "the database may not be written";
        case Kind::Full:
            return "the disk is full, nothing was stored";
        case Kind::Damaged:
            return "the database is damaged";
        default:
            return "the database refused a statement";
    }
}

std::string advice(Kind kind) {
    switch (kind) {
        case Kind::CannotOpen:
            return "Check that file and folder exist and that this user may read and write them.";
        case Kind::Locked:
            return "Close the other program, or wait until it is done, and try again.";
        case Kind::ReadOnly:
            return "Give this user the right to write the file and its folder, or choose another one.";
        case Kind::Full:
            return "Free some space and try again.";
        case Kind::Damaged:
            return "Move it and what lies beside it (-wal, -shm) away and put a backup in its place; it was "
                   "left as it is.";
        case Kind::Newer:
            return "Update Sagara or choose another data folder; the file was left as it is.";
        case Kind::Foreign:
            return "Choose another data folder; the file was left as it is.";
        case Kind::Other:
            break;
    }
    return "Check the disk and the quota; if they are sound, please report this message.";
}

}  // namespace

DbError::Kind kindOf(int sqliteCode) {
    switch (sqliteCode & 0xff) {
        case 3 /*PERM*/:
        case 14 /*CANTOPEN*/:
            return Kind::CannotOpen;
        case 5 /*BUSY*/:
        case 6 /*LOCKED*/:
            return Kind::Locked;
        case 8 /*READONLY*/:
            return Kind::ReadOnly;
        case 11 /*CORRUPT*/:
        case kNotADatabase:
            return Kind::Damaged;
        case 13 /*FULL*/:
            return Kind::Full;
        default:
            return Kind::Other;
    }
}

DbError failure(const Connection& connection, const QSqlError& error) {
    if (error.nativeErrorCode().isEmpty()) {  // Qt's own: no driver, or a statement that was never sent
        const Kind kind = error.type() == QSqlError::ConnectionError ? Kind::CannotOpen : Kind::Other;
        return problem(kind, connection.file(), "Qt SQL says: " + error.text().toStdString());
    }
    const int code = error.nativeErrorCode().toInt();
    const std::string cause = error.databaseText().toStdString() + ", SQLite " + std::to_string(code);
    return problem(kindOf(code), connection.file(), found(code, connection) + " (" + cause + ")");
}

DbError problem(DbError::Kind kind, const std::filesystem::path& file, const std::string& found) {
    return DbError(kind, file.string() + ": " + found + ". " + advice(kind));
}

}  // namespace sagara::db
