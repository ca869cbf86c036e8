#include "db/FileRun.h"

#include "db/Database.h"
#include "db/Transaction.h"

namespace sagara::db {
namespace {

RunId startedOnce(RunRepository& runs, const NewRun& start) {
    const std::optional<RunRecord> known = runs.findByRecording(start.recordingFile);
    return known ? known->id : runs.start(start);
}

}  // namespace

RunId fileRun(Database& db, const EndedRun& run) {
    RunRepository runs(db);
    GradeRepository grades(db);
    Transaction transaction(db);
    const RunId id = startedOnce(runs, run.start);
    runs.finish(id, run.result);
    if (run.grade && !grades.find(id)) grades.put(id, *run.grade);
    transaction.commit();
    return id;
}

}  // namespace sagara::db
