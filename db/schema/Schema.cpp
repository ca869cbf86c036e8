#include "db/schema/Schema.h"

#include <array>

namespace sagara::db {

std::span<const Migration> migrations() {
    static constexpr std::array<Migration, kSchemaVersion> kMigrations{toVersion1, toVersion2, toVersion3};
    return kMigrations;
}

}  // namespace sagara::db
