#include "db/schema/Schema.h"
#include "db/sql/Query.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;

const auto kSeakeeping =
    uR"(CREATE TABLE seakeeping (
    id INTEGER PRIMARY KEY,
    input_hash INTEGER NOT NULL UNIQUE,
    tables BLOB NOT NULL
) STRICT)"_s;

}  // namespace

void toVersion3(Connection& connection) { execute(connection, kSeakeeping); }

}  // namespace sagara::db
