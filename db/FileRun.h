#pragma once

#include <optional>

#include "db/GradeRepository.h"
#include "db/RunRepository.h"

namespace sagara::db {

class Database;

/// What a recording says about a run that has ended.
struct EndedRun {
    NewRun start;
    RunResult result;
    std::optional<Grade> grade;
};

/// Enters a run that begins with a recording file of its own: one of that name from before is replaced, and
/// the run it held says so.
RunId beginRun(Database& db, const NewRun& start);

/// Files a run in one transaction: for a recording that could not be filed when it was made. The recording's
/// name decides what is missing (the run, its end, its grade); filing it again changes nothing. A file of
/// that name that held another run has been replaced.
RunId fileRun(Database& db, const EndedRun& run);

}  // namespace sagara::db
