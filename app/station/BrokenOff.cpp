#include "app/station/BrokenOff.h"

#include "app/files/Files.h"
#include "app/run/RecordingFile.h"
#include "core/exercise/Recording.h"
#include "db/RunRepository.h"

namespace sagara::station {
namespace {

constexpr int kLooked = 50;
constexpr std::size_t kMost = 3;

}  // namespace

std::vector<BrokenOff> brokenOffRuns(run::Store& store) {
    std::vector<BrokenOff> found;
    if (store.database() == nullptr) return found;
    std::vector<db::RunRecord> runs;
    try {
        runs = db::RunRepository(*store.database()).list({kLooked, 0});
    } catch (const db::DbError&) {
        return found;  // whoever needs the database next will tell
    }
    for (const db::RunRecord& run : runs) {
        if (run.status != db::RunStatus::Running || found.size() == kMost) continue;
        const std::filesystem::path path = store.folder().pathOf(run.start.recordingFile);
        if (run::RecordingFile::isBeingWritten(path)) continue;
        const auto bytes = files::readBinaryFile(path);
        if (!bytes) continue;
        const auto recording = core::readRecording(*bytes);
        if (!recording || recording->end) continue;
        found.push_back({path, run.start.scenarioName, recording->header.trainee, run.start.started,
                         core::timeOfTick(recording->endTick).seconds(), recording->sameBuild()});
    }
    return found;
}

}  // namespace sagara::station
