#include "db/sql/Backup.h"

#include <exception>

#include "db/sql/Failure.h"
#include "db/sql/FileCheck.h"
#include "db/sql/Query.h"
#include "db/sql/TemporaryFile.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;
using Kind = DbError::Kind;
namespace fs = std::filesystem;

DbError refused(const fs::path& copy, const std::string& why) {
    return DbError(Kind::CannotOpen,
                   copy.string() + ": no backup was made: " + why + ". Choose another name.");
}

/// Replacing a database that someone has open, or whose log still waits beside it, would mix the two.
void requireAtRest(const fs::path& copy) {
    std::error_code none;
    for (const char* suffix : {"-wal", "-journal"}) {
        if (!fs::exists(copy.string() + suffix, none)) continue;
        throw refused(copy, "a program has that file open or did not close it (" + copy.filename().string() +
                                suffix + " lies beside it)");
    }
}

void requireFree(const fs::path& source, const fs::path& copy, Database::Existing existing) {
    std::error_code none;  // a folder that may not be entered shows when the copy is made
    if (!fs::is_directory(copy.parent_path(), none)) throw refused(copy, "there is no such folder");
    requireAtRest(copy);
    if (!fs::exists(copy, none)) return;
    if (!fs::is_regular_file(copy, none)) throw refused(copy, "that is not a file");
    if (fs::equivalent(copy, source, none)) throw refused(copy, "that is the database itself");
    if (existing == Database::Existing::Overwrite) return;
    throw refused(copy, "the file exists and it was not asked to overwrite it");
}

void requireSound(const fs::path& copy) {
    Connection connection(copy, Connection::Access::ReadOnly, kBusyTimeout);
    const std::vector<std::string> faults = faultsFound(connection, true);
    if (!faults.empty()) throw problem(Kind::Damaged, copy, "the copy is not sound: " + faults.front());
}

void copyTo(Connection& connection, const fs::path& copy, Database::Existing existing) {
    requireWritable(copy);
    const TemporaryFile temporary(copy);
    execute(connection, u"VACUUM INTO ?"_s, temporary.path().string());
    requireSound(temporary.path());
    if (existing == Database::Existing::Overwrite) return temporary.moveOverTarget();
    if (!temporary.moveToNewTarget()) throw refused(copy, "the file appeared meanwhile");
}

}  // namespace

void backup(Connection& connection, const fs::path& wanted, Database::Existing existing) {
    if (wanted.empty()) throw refused(wanted, "the name is empty");
    const fs::path copy = fs::absolute(wanted).lexically_normal();
    requireFree(connection.file(), copy, existing);
    try {
        copyTo(connection, copy, existing);
    } catch (const DbError& cause) {
        std::throw_with_nested(
            DbError(cause.kind(), copy.string() + ": no backup was made: " + cause.what()));
    }
}

}  // namespace sagara::db
