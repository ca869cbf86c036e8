#pragma once

#include "app/run/RunOptions.h"
#include "app/run/Store.h"

namespace sagara::run {

/// Runs an exercise from begin to end (or takes one up again), records, grades and files it, and writes what
/// was asked for. Result on standard output, progress and trouble on standard error. Returns the exit code.
int runExercise(Store& store, const RunOptions& options);

/// Runs a recording again, or grades its track, and writes what was asked for. Returns the exit code.
int replayRecording(const ReplayOptions& options);

}  // namespace sagara::run
