#pragma once

#include <filesystem>
#include <string>

#include "app/run/Store.h"

namespace sagara::run {

/// Prints what the database holds: "vessels", "areas", "scenarios" or "runs". Returns the exit code; throws
/// DbError, as does backupDatabase.
int listDatabase(Store& store, const std::string& what);

/// Copies the database while it is in use. Returns the exit code.
int backupDatabase(const Store& store, const std::filesystem::path& to);

}  // namespace sagara::run
