#pragma once

#include <mutex>

#include "app/live/LiveRun.h"
#include "app/run/RecordingFile.h"
#include "app/run/RunFiling.h"
#include "app/run/TakeUp.h"

namespace sagara::station {

/// One recorded stretch of a run, from its start, or from where it was taken up or gone back to, to its end:
/// the thread that sails it, the file it is kept in and its row in the database. A run that goes back begins
/// another leg, with a recording of its own; what was sailed meanwhile stays in the first.
class RunLeg {
public:
    /// A new run.
    static core::Result<std::unique_ptr<RunLeg>, std::string> begin(run::Store& store,
                                                                    std::shared_ptr<const core::World> world,
                                                                    core::RecordingHeader header);
    /// Goes on in the file of a run that was broken off.
    static core::Result<std::unique_ptr<RunLeg>, std::string> takeUp(run::Store& store,
                                                                     const std::filesystem::path& recording);
    /// Sails anew from a whole second of another, in a copy of its recording up to there.
    static core::Result<std::unique_ptr<RunLeg>, std::string> sailAgain(run::Store& store, run::SetBack back);
    ~RunLeg() { end(); }

    const std::shared_ptr<const core::World>& world() const { return m_world; }
    const core::RecordingHeader& header() const { return m_header; }
    live::LiveRun& live() const { return *m_live; }
    const std::filesystem::path& recording() const { return m_file->path(); }
    /// Of what was sailed before this leg.
    const std::vector<core::TrackSample>& sailedBefore() const { return m_sailedBefore; }
    std::string trouble() const;

    /// Stops, writes the end, grades and files. Once; the same result after that.
    const run::RunSummary& end();
    bool ended() const { return m_summary.has_value(); }

private:
    RunLeg(run::Store& store, std::shared_ptr<const core::World> world,
           std::unique_ptr<run::RecordingFile> file, core::RecordingHeader header);
    void sail(core::State start, std::vector<core::Event> past);
    void write(std::span<const std::byte> bytes);

    std::shared_ptr<const core::World> m_world;
    std::unique_ptr<run::RecordingFile> m_file;
    core::RecordingHeader m_header;
    run::RunFiling m_filing;
    db::NewRun m_run;
    core::RecordingWriter m_writer;
    std::vector<core::TrackSample> m_sailedBefore;
    std::unique_ptr<live::LiveRun> m_live;
    std::optional<run::RunSummary> m_summary;
    std::string m_filingTrouble;
    mutable std::mutex m_mutex;
    std::string m_recordingTrouble;  ///< under m_mutex: the thread of the run writes it
};

}  // namespace sagara::station
