#include "app/run/RecordingReport.h"

#include <exception>

#include "app/files/Files.h"
#include "app/run/FillReport.h"
#include "app/run/GradeRecording.h"
#include "core/exercise/Replay.h"

namespace sagara::run {
namespace {

/// As it was graded when it was sailed; a recording of another build is graded from its track. Neither sails
/// the whole run again.
RunSummary summaryOf(const core::World& world, const core::Recording& recording) {
    const auto last = core::stateAt(world, recording, recording.endTick);
    if (!last) return gradeRecording(world, recording, recording.endTick);
    RunSummary summary =
        summarise(world, world.mission, last->assessment, assessmentEvents(recording.events));
    summary.simTime_s = last->time().seconds();
    summary.stateHash = core::toHex(core::stateHash(*last));
    summary.gradedFrom = "the run itself, to the bit";
    return summary;
}

}  // namespace

std::string writeRecordingReport(const std::filesystem::path& path,
                                 const std::optional<report::AssessorNote>& assessor,
                                 const std::filesystem::path& to, std::shared_ptr<core::SeaHulls> hulls,
                                 const std::function<bool(int)>& goOn) {
    const auto bytes = files::readBinaryFile(path);
    if (!bytes) return bytes.error().message;
    if (!goOn(10)) return {};
    const auto recording = core::readRecording(*bytes);
    if (!recording) return path.string() + ": " + recording.error();
    if (!goOn(20)) return {};
    const auto world = core::worldOf(*recording, std::move(hulls));
    if (!world) return world.error().text();
    if (!goOn(50)) return {};
    const RunSummary summary = summaryOf(**world, *recording);
    if (!goOn(70)) return {};
    try {
        report::RunReport report = fillReport(**world, (*world)->mission, *recording, summary);
        report.assessor = assessor;
        if (!goOn(85)) return {};
        report::writeReport(report, to.string());
    } catch (const std::exception& e) {
        return e.what();
    }
    goOn(100);
    return {};
}

}  // namespace sagara::run
