#pragma once

#include <mutex>
#include <optional>

#include "app/live/LiveRun.h"
#include "app/run/RecordingFile.h"
#include "app/run/RunFiling.h"
#include "app/station/RunRequest.h"
#include "ui/run/ExerciseRun.h"

namespace sagara::station {

/// An exercise of the station: runs live, is recorded from its first tick, and is listed in the database.
class StationRun final : public ui::ExerciseRun {
public:
    /// The error is for the person who chose. `store` outlives the run.
    static core::Result<std::unique_ptr<StationRun>, std::string> open(run::Store& store,
                                                                       const RunRequest& request);
    ~StationRun() override;

    const std::shared_ptr<const core::World>& world() const override { return m_world; }
    std::shared_ptr<const core::Snapshot> latest() const override { return m_live->latest(); }
    core::State state() const override { return m_live->state(); }
    Picture toDraw() override;
    std::vector<core::Event> eventsFrom(std::size_t index) const override {
        return m_live->eventsFrom(index);
    }
    void start() override { m_live->start(); }
    void freeze() override { m_live->freeze(); }
    bool running() const override { return m_live->running(); }
    bool over() const override { return m_live->over() || m_summary.has_value(); }
    void setRate(double times) override { m_live->setRate(times); }
    double rate() const override { return m_live->rate(); }
    double lagged_s() const override { return m_live->lagged_s(); }
    void give(std::uint8_t ship, core::Order order) override { m_live->give(ship, std::move(order)); }
    std::string trouble() const override;

    /// Ends the run, writes the end of its recording, grades and files it. Once; the same result after that.
    const run::RunSummary& end();
    const std::filesystem::path& recording() const { return m_file->path(); }

private:
    StationRun(run::Store& store, std::shared_ptr<const core::World> world,
               std::unique_ptr<run::RecordingFile> file, core::RecordingHeader header);

    std::shared_ptr<const core::World> m_world;
    std::unique_ptr<run::RecordingFile> m_file;
    run::RunFiling m_filing;
    db::NewRun m_run;
    core::RecordingWriter m_writer;
    std::unique_ptr<live::LiveRun> m_live;
    std::optional<run::RunSummary> m_summary;
    std::string m_filingTrouble;
    mutable std::mutex m_mutex;
    std::string m_recordingTrouble;  ///< under m_mutex: the thread of the run writes it
};

}  // namespace sagara::station
