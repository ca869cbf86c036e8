#include "app/run/Store.h"

/// Restoring a backup: checked in a copy, then renamed into place, the database before kept beside it.
namespace sagara::run {
namespace {

namespace fs = std::filesystem;

/// A database in the making and what SQLite puts beside it.
void removeDatabase(const fs::path& file) {
    std::error_code ignored;
    for (const char* suffix : {"", "-wal", "-shm", "-journal"}) fs::remove(file.string() + suffix, ignored);
}

/// A copy of the backup, opened: raised to the present schema and checked in full.
std::vector<std::string> copyAndCheck(const fs::path& backup, const fs::path& copy) {
    removeDatabase(copy);
    std::error_code trouble;
    if (!fs::is_regular_file(backup, trouble)) return {backup.string() + " is not there, or is no file"};
    fs::copy_file(backup, copy, trouble);
    if (trouble) return {backup.string() + " cannot be copied: " + trouble.message()};
    try {
        return db::Database(copy).integrity();
    } catch (const db::DbError& e) {
        return {e.what()};
    }
}

}  // namespace

std::vector<std::string> Store::checkBackup(const fs::path& backup) const {
    const fs::path copy = m_folder.root() / "sagara-checking.db";
    std::vector<std::string> wrong = copyAndCheck(backup, copy);
    removeDatabase(copy);
    return wrong;
}

std::optional<std::string> Store::restoreDatabase(const fs::path& backup) {
    const fs::path fresh = m_folder.root() / "sagara-restoring.db", file = m_folder.database();
    const std::vector<std::string> wrong = copyAndCheck(backup, fresh);
    if (!wrong.empty()) {
        removeDatabase(fresh);
        return wrong.front();
    }
    try {
        if (m_database) m_database->backupTo(keptDatabase(), db::Database::Existing::Overwrite);
    } catch (const db::DbError& e) {
        removeDatabase(fresh);
        return std::string("the present database could not be kept: ") + e.what();
    }
    m_database.reset();
    m_trouble.clear();
    std::error_code trouble;
    if (!fs::exists(keptDatabase(), trouble))
        fs::copy_file(file, keptDatabase(), trouble);  // one that would not open
    removeDatabase(file);
    fs::rename(fresh, file, trouble);
    openDatabase();
    if (trouble) return file.string() + " could not be written: " + trouble.message();
    if (!m_database) return m_trouble;
    return std::nullopt;
}

}  // namespace sagara::run
