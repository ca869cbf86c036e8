#include "app/run/Lists.h"

#include <fmt/format.h>

#include "app/run/Console.h"
#include "app/run/RunFiling.h"
#include "app/run/RunOptions.h"
#include "app/run/RunSummary.h"
#include "db/DocumentRepository.h"
#include "db/GradeRepository.h"
#include "db/PersonRepository.h"
#include "db/RunRepository.h"

namespace sagara::run {
namespace {

void listDocuments(db::Database& database, db::DocumentTable table) {
    for (const db::DocumentEntry& e : db::DocumentRepository(database, table).inUse()) {
        print(fmt::format("{:<24} {:<44} {:<8} {}\n", e.key, e.name, db::toText(e.origin),
                          core::toHex(e.contentHash)));
    }
}

std::string gradeOf(const std::optional<db::Grade>& grade) {
    if (!grade) return "-";
    return fmt::format("{:.0f} {}", grade->score, grade->passed ? "passed" : "not passed");
}

/// Files those first that could not be when they were sailed: here they are looked for.
void listRuns(Store& store) {
    for (const std::string& message : RunFiling(store).fileNoted()) tell(message);
    db::Database& database = *store.database();
    const db::PersonRepository people(database);
    const db::GradeRepository grades(database);
    for (const db::RunRecord& r : db::RunRepository(database).list()) {
        const auto person = r.start.person ? people.find(*r.start.person) : std::nullopt;
        print(fmt::format("{}  {:<20} level {}  {:<11} {:<9} {:>8}  {:<15} {:<20} {}\n",
                          core::formatUtc(r.start.started), r.start.scenarioKey, r.start.level,
                          db::toText(r.start.type), db::toText(r.status), clock(r.simTime.seconds()),
                          gradeOf(grades.find(r.id)), person ? person->name : "-", r.start.recordingFile));
    }
}

}  // namespace

int listDatabase(Store& store, const std::string& what) {
    if (!store.database()) return tell(store.trouble()), kMachineFailed;
    if (what == "vessels") listDocuments(*store.database(), db::DocumentTable::Vessel);
    if (what == "areas") listDocuments(*store.database(), db::DocumentTable::Area);
    if (what == "scenarios") listDocuments(*store.database(), db::DocumentTable::Scenario);
    if (what == "runs") listRuns(store);
    return kDone;
}

int backupDatabase(const Store& store, const std::filesystem::path& to) {
    if (!store.database()) return tell(store.trouble()), kMachineFailed;
    store.database()->backupTo(to);
    print("The database was copied to " + to.string() + ".\n");
    return kDone;
}

}  // namespace sagara::run
