#pragma once

#include <cstdint>
#include <span>

#include "db/sql/Migrate.h"

namespace sagara::db {

/// "SAGA", in the header of every file we make; tells our databases from anyone else's.
inline constexpr std::int32_t kApplicationId = 0x53414741;

/// Grows by one with each migration; never edit one that was released.
inline constexpr int kSchemaVersion = 3;

/// Migration n makes version n + 1 of version n; version 0 is an empty file.
std::span<const Migration> migrations();

void toVersion1(Connection& connection);
void toVersion2(Connection& connection);
void toVersion3(Connection& connection);

}  // namespace sagara::db
