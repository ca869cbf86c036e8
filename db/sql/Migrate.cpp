#include "db/sql/Migrate.h"

#include "db/Transaction.h"
#include "db/sql/Failure.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;

void requireReferences(Connection& connection) {
    Query dangling(connection, u"PRAGMA foreign_key_check"_s);
    if (!dangling.next()) return;
    throw problem(
        DbError::Kind::Damaged, connection.file(),
        "table " + dangling.text(u"table"_s) + " refers to a missing row of " + dangling.text(u"parent"_s));
}

}  // namespace

int schemaVersion(Connection& connection) {
    Query row(connection, u"PRAGMA user_version"_s);
    row.next();
    return static_cast<int>(row.integer(u"user_version"_s));
}

void migrate(Connection& connection, std::span<const Migration> migrations) {
    const int last = static_cast<int>(migrations.size());
    if (schemaVersion(connection) == last) return;
    Transaction transaction(connection);
    // Asked again under the lock: another program may have been faster.
    for (int version = schemaVersion(connection); version < last; ++version) {
        migrations[static_cast<std::size_t>(version)](connection);
        execute(connection, u"PRAGMA user_version = %1"_s.arg(version + 1));
    }
    requireReferences(connection);
    transaction.commit();
}

}  // namespace sagara::db
