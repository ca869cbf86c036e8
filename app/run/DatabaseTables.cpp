#include "app/run/DatabaseTables.h"

#include "core/base/Archive.h"
#include "db/Database.h"
#include "db/SeakeepingRepository.h"

namespace sagara::run {
namespace {

constexpr std::chrono::milliseconds kPatience{500};

/// Opening would make a new file in place of a lost one.
template <typename Do>
void withDatabase(const std::filesystem::path& file, Do&& act) {
    std::error_code hidden;
    if (!std::filesystem::exists(file, hidden)) return;
    try {
        db::Database database(file, kPatience);
        act(db::SeakeepingRepository(database));
    } catch (const db::DbError&) {
        // Whoever needs the database for more than this tells the person.
    }
}

}  // namespace

std::optional<core::SeakeepingTables> DatabaseTables::find(std::uint64_t inputHash) {
    std::optional<core::SeakeepingTables> found;
    withDatabase(m_database, [&](const db::SeakeepingRepository& kept) {
        const auto bytes = kept.find(inputHash);
        if (bytes) found = core::fromBytes<core::SeakeepingTables>(std::as_bytes(std::span(*bytes)));
    });
    return found;
}

void DatabaseTables::keep(const core::SeakeepingTables& tables) {
    const core::Bytes bytes = core::toBytes(tables);
    withDatabase(m_database, [&](db::SeakeepingRepository kept) {
        kept.keep(tables.inputHash, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    });
}

}  // namespace sagara::run
