#pragma once

#include <optional>
#include <string>

#include "app/run/RunSummary.h"
#include "app/run/Store.h"
#include "core/exercise/Recording.h"
#include "db/FileRun.h"

namespace sagara::run {

/// A name for a new recording in the data folder: time, scenario and a number.
std::filesystem::path newRecordingPath(const Store& store, const std::string& scenario);

/// The header of a recording of this exercise, begun now; nothing planned yet.
core::RecordingHeader newHeader(const core::World& world, int level, std::string runType,
                                std::string trainee);

/// Enters runs into the database. None of these throws or stops a run: what cannot be filed is noted beside
/// the recordings (recordings/*.unfiled) and filed by a later start.
class RunFiling {
public:
    explicit RunFiling(Store& store) : m_store(store) {}

    /// What can be told of a run before it begins. Names the trainee, who is added to the roster when new.
    db::NewRun newRun(const core::RecordingHeader& header, const core::World& world,
                      const std::filesystem::path& recording);
    /// Marks it as running. Returns a message when that failed.
    std::string begin(const db::NewRun& run);
    /// Enters its end and grade, or notes the recording for later and says so.
    std::string end(const db::NewRun& run, const RunSummary& summary, bool finished);

    /// Enters a run that was broken off as it stands in its recording. Returns a message when that failed.
    std::string fileAsItStands(const std::filesystem::path& recording) {
        return fileFromRecording(recording);
    }
    /// Files the runs noted earlier, and those whose recording has its end though the database knows none.
    /// One message for each that was filed or still cannot be.
    std::vector<std::string> fileNoted();

private:
    std::string note(const std::string& recordingName);
    std::vector<std::string> endedUnfiled();
    std::string fileFromRecording(const std::filesystem::path& recording);

    Store& m_store;
};

}  // namespace sagara::run
