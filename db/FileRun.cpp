#include "db/FileRun.h"

#include "db/Database.h"
#include "db/Transaction.h"

namespace sagara::db {
namespace {

/// What a recording's header says; names may have changed since.
bool isSameRun(const NewRun& a, const NewRun& b) {
    return a.started == b.started && a.seed == b.seed && a.level == b.level &&
           a.scenarioKey == b.scenarioKey && a.buildId == b.buildId;
}

RunId startedOnce(RunRepository& runs, const NewRun& start) {
    const std::optional<RunRecord> known = runs.findByRecording(start.recordingFile);
    if (known && isSameRun(known->start, start)) return known->id;
    if (known) runs.releaseRecording(start.recordingFile);
    return runs.start(start);
}

}  // namespace

RunId beginRun(Database& db, const NewRun& start) {
    RunRepository runs(db);
    Transaction transaction(db);
    runs.releaseRecording(start.recordingFile);
    const RunId id = runs.start(start);
    transaction.commit();
    return id;
}

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
