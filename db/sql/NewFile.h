#pragma once

#include <filesystem>

namespace sagara::db {

/// Makes an empty database of the current schema, and its folder. The file appears under its name only when
/// whole, so that neither a crash nor a second program ever meets half of one. Does nothing when the file
/// exists by then.
void makeNewFile(const std::filesystem::path& file);

}  // namespace sagara::db
