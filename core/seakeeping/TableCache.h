#pragma once

#include <cstdint>
#include <optional>

#include "core/seakeeping/MakeTables.h"

namespace sagara::core {

/// Port: where tables are kept between runs. Who keeps them owes nothing: what is lost is made again.
class TableCache {
public:
    virtual ~TableCache() = default;
    virtual std::optional<SeakeepingTables> find(std::uint64_t inputHash) = 0;
    virtual void keep(const SeakeepingTables& tables) = 0;
};

/// Those of the cache if it has them; else made, and given to it. Without a cache: made.
SeakeepingTables tablesFor(const HullForm& form, const TableOptions& options = {},
                           TableCache* cache = nullptr);

}  // namespace sagara::core
