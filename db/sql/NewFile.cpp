#include "db/sql/NewFile.h"

#include "db/Database.h"
#include "db/schema/Schema.h"
#include "db/sql/Failure.h"
#include "db/sql/FileCheck.h"
#include "db/sql/Migrate.h"
#include "db/sql/Query.h"
#include "db/sql/TemporaryFile.h"

namespace sagara::db {
namespace {

using namespace Qt::StringLiterals;

void makeFolder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw problem(DbError::Kind::CannotOpen, folder, "the folder cannot be made: " + error.message());
}

void makeSchema(const std::filesystem::path& file) {
    Connection connection(file, Connection::Access::Create, kBusyTimeout);
    execute(connection, u"PRAGMA application_id = %1"_s.arg(kApplicationId));
    migrate(connection, migrations());
    execute(connection, u"PRAGMA journal_mode = WAL"_s);
}

}  // namespace

void makeNewFile(const std::filesystem::path& file) {
    makeFolder(file.parent_path());
    requireWritable(file);
    const TemporaryFile temporary(file);
    makeSchema(temporary.path());
    temporary.moveToNewTarget();
}

}  // namespace sagara::db
