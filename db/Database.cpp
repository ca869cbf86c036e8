#include "db/Database.h"

#include "core/base/Hash.h"
#include "db/schema/Schema.h"
#include "db/sql/Backup.h"
#include "db/sql/FileCheck.h"
#include "db/sql/Migrate.h"
#include "db/sql/NewFile.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;

/// A file of an older version is kept beside the raised one, for whoever must go back to the older program.
void keepOlder(Connection& connection) {
    const int version = schemaVersion(connection);
    if (version == kSchemaVersion) return;
    const std::filesystem::path copy = olderCopy(connection.file(), version);
    if (!std::filesystem::exists(copy)) backup(connection, copy, Database::Existing::Refuse);
}

void configure(Connection& connection) {
    execute(connection, u"PRAGMA journal_mode = WAL"_s);  // a restored backup is not
    execute(connection, u"PRAGMA synchronous = NORMAL"_s);
    keepOlder(connection);
    migrate(connection, migrations());
    execute(connection, u"PRAGMA foreign_keys = ON"_s);
}

std::unique_ptr<Connection> openFile(const std::filesystem::path& file,
                                     std::chrono::milliseconds busyTimeout) {
    std::error_code hidden;  // of a folder that may not be entered; told further on
    if (!std::filesystem::exists(file, hidden)) makeNewFile(file);
    requireOurs(file, busyTimeout);
    auto connection = std::make_unique<Connection>(file, Connection::Access::ReadWrite, busyTimeout);
    configure(*connection);
    connection->noteFile();
    return connection;
}

std::int64_t number(Connection& connection, const QString& sql, const QString& column) {
    Query row(connection, sql);
    row.next();
    return row.integer(column);
}

std::vector<TableCount> countRows(Connection& connection) {
    std::vector<TableCount> counts;
    Query table(connection, u"SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name"_s);
    while (table.next()) {
        const std::string name = table.text(u"name"_s);
        const QString sql = u"SELECT count(*) AS rows FROM \"%1\""_s.arg(QString::fromStdString(name));
        counts.push_back({name, number(connection, sql, u"rows"_s)});
    }
    return counts;
}

void addDanglingReferences(Connection& connection, std::vector<std::string>& problems) {
    Query row(connection, u"PRAGMA foreign_key_check"_s);
    while (row.next()) {
        problems.push_back(row.text(u"table"_s) + " " + row.text(u"rowid"_s) +
                           ": refers to a missing row of " + row.text(u"parent"_s));
    }
}

/// SQLite keeps no sums over its pages: a flipped byte inside a text shows only here.
void addChangedDocuments(Connection& connection, const QString& table, std::vector<std::string>& problems) {
    Query row(connection,
              u"SELECT key, content_hash, CAST(document AS BLOB) AS document FROM %1"_s.arg(table));
    while (row.next()) {
        if (core::toHex(core::hashOf(row.bytes(u"document"_s))) == row.text(u"content_hash"_s)) continue;
        problems.push_back(table.toStdString() + " " + row.text(u"key"_s) +
                           ": the document is not the one stored");
    }
}

void addWrongRows(Connection& connection, std::vector<std::string>& problems) {
    addDanglingReferences(connection, problems);
    for (const QString& table : {u"vessel"_s, u"area"_s, u"scenario"_s, u"document_history"_s}) {
        addChangedDocuments(connection, table, problems);
    }
}

}  // namespace

std::filesystem::path olderCopy(const std::filesystem::path& file, int version) {
    return file.parent_path() /
           (file.stem().string() + "-version-" + std::to_string(version) + file.extension().string());
}

Database::Database(const std::filesystem::path& file, std::chrono::milliseconds busyTimeout)
    : m_connection(openFile(std::filesystem::absolute(file).lexically_normal(), busyTimeout)) {}

Database::~Database() = default;

DatabaseInfo Database::info() const {
    Connection& c = *m_connection;
    const std::int64_t pages = number(c, u"PRAGMA page_count"_s, u"page_count"_s);
    const std::int64_t page_bytes = number(c, u"PRAGMA page_size"_s, u"page_size"_s);
    return {c.file(), pages * page_bytes, schemaVersion(c), countRows(c)};
}

std::vector<std::string> Database::integrity() const {
    try {
        std::vector<std::string> problems = faultsFound(*m_connection, true);
        // Rows of a broken file would only mislead.
        if (problems.empty()) addWrongRows(*m_connection, problems);
        return problems;
    } catch (const DbError& error) {
        if (error.kind() != DbError::Kind::Damaged) throw;
        return {error.what()};
    }
}

void Database::backupTo(const std::filesystem::path& copy, Existing existing) const {
    backup(*m_connection, copy, existing);
}

}  // namespace sagara::db
