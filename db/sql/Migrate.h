#pragma once

#include <span>

namespace sagara::db {

class Connection;

/// Turns version n into n + 1, n being its place in the list.
using Migration = void (*)(Connection&);

int schemaVersion(Connection& connection);

/// Raises the schema to the last version of the list, in one transaction: all of it or nothing. Foreign keys
/// must still be off on this connection, so that a migration may rebuild a table; they are checked at the
/// end.
void migrate(Connection& connection, std::span<const Migration> migrations);

}  // namespace sagara::db
