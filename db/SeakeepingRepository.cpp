#include "db/SeakeepingRepository.h"

#include "db/Database.h"
#include "db/Transaction.h"
#include "db/sql/Query.h"

namespace sagara::db {

using namespace Qt::StringLiterals;

std::optional<std::string> SeakeepingRepository::find(std::uint64_t inputHash) const {
    Query row(m_db.connection(), u"SELECT tables FROM seakeeping WHERE input_hash = ?"_s,
              signedBits(inputHash));
    if (!row.next()) return std::nullopt;
    return row.bytes(u"tables"_s);
}

void SeakeepingRepository::keep(std::uint64_t inputHash, std::string_view bytes) {
    Transaction transaction(m_db);
    execute(m_db.connection(),
            u"INSERT INTO seakeeping (input_hash, tables) VALUES (?, ?) "
            "ON CONFLICT (input_hash) DO UPDATE SET tables = excluded.tables"_s,
            signedBits(inputHash), Bytes{bytes});
    execute(m_db.connection(),
            u"DELETE FROM seakeeping WHERE id NOT IN (SELECT id FROM seakeeping ORDER BY id DESC LIMIT ?)"_s,
            kMost);
    transaction.commit();
}

}  // namespace sagara::db
