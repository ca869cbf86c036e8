#pragma once

#include <QSqlError>
#include <filesystem>
#include <string>

#include "db/DbError.h"

namespace sagara::db {

class Connection;

/// Primary SQLite result code (https://www.sqlite.org/rescode.html) to our kind; extended codes are reduced
/// first.
DbError::Kind kindOf(int sqliteCode);

/// What failed on this connection, told to a person.
DbError failure(const Connection& connection, const QSqlError& error);

/// "FILE: FOUND. TODO" with the advice that goes with the kind.
DbError problem(DbError::Kind kind, const std::filesystem::path& file, const std::string& found);

}  // namespace sagara::db
