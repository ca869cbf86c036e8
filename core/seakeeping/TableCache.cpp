#include "core/seakeeping/TableCache.h"

namespace sagara::core {

SeakeepingTables tablesFor(const HullForm& form, const TableOptions& options, TableCache* cache) {
    if (cache == nullptr) return makeTables(form, options);
    const std::uint64_t hash = tablesHash(form, options);
    if (std::optional<SeakeepingTables> found = cache->find(hash); found && found->inputHash == hash)
        return *std::move(found);
    SeakeepingTables tables = makeTables(form, options);
    cache->keep(tables);
    return tables;
}

}  // namespace sagara::core
