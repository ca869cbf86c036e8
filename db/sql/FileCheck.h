#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace sagara::db {

class Connection;

/// Throws unless file and folder, as far as they exist, may be written by this user.
void requireWritable(const std::filesystem::path& file);

/// Throws unless this existing file is a whole database of Sagara, of a schema version that this program
/// reads. Changes neither the file nor what a crashed program left beside it.
void requireOurs(const std::filesystem::path& file, std::chrono::milliseconds busyTimeout);

/// Answer of `PRAGMA quick_check` or `PRAGMA integrity_check`; empty when all is well.
std::vector<std::string> faultsFound(Connection& connection, bool thorough);

}  // namespace sagara::db
