#pragma once

#include <filesystem>

#include "db/Database.h"

namespace sagara::db {

/// See Database::backupTo.
void backup(Connection& connection, const std::filesystem::path& copy, Database::Existing existing);

}  // namespace sagara::db
