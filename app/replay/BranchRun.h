#pragma once

#include <mutex>
#include <optional>

#include "app/live/LiveRun.h"
#include "app/replay/Film.h"
#include "app/run/RecordingFile.h"
#include "app/run/RunFiling.h"
#include "ui/debrief/Branch.h"

namespace sagara::replay {

/// "What if": a run that begins as a recorded one and is sailed anew from a second of it. It is live, filed
/// as training that nobody is credited for, and has a recording of its own, which begins with the part that
/// was sailed before and replays from there. The recording it leaves is only read.
class BranchRun final : public ui::Branch {
public:
    /// `from`: the film's state at a whole second. `store` outlives the run. The error is for a person.
    static core::Result<std::unique_ptr<BranchRun>, std::string> open(run::Store& store,
                                                                      std::shared_ptr<const Film> film,
                                                                      core::State from);
    ~BranchRun() override;

    const std::shared_ptr<const core::World>& world() const override { return m_film->world; }
    std::shared_ptr<const core::Snapshot> latest() const override { return m_live->latest(); }
    core::State state() const override { return m_live->state(); }
    Picture toDraw() override;
    std::vector<core::Event> eventsFrom(std::size_t index) const override {
        return m_live->eventsFrom(index);
    }
    void start() override { m_live->start(); }
    void freeze() override { m_live->freeze(); }
    bool running() const override { return m_live->running(); }
    bool over() const override { return m_live->over() || finished(); }
    void setRate(double times) override { m_live->setRate(times); }
    double rate() const override { return m_live->rate(); }
    double lagged_s() const override { return m_live->lagged_s(); }
    void give(std::uint8_t ship, core::Order order) override { m_live->give(ship, std::move(order)); }
    std::string trouble() const override;

    core::SimTime from() const override { return core::timeOfTick(m_from); }
    std::vector<core::TrackSample> track() const override;
    const std::string& finish() override;
    bool finished() const override { return m_outcome.has_value(); }
    std::string recordingName() const override { return m_file->path().filename().string(); }
    const std::filesystem::path& recording() const { return m_file->path(); }

private:
    struct Beginning;
    BranchRun(run::Store& store, std::shared_ptr<const Film> film, Beginning beginning);
    void write(std::span<const std::byte> bytes);

    std::shared_ptr<const Film> m_film;
    std::int64_t m_from;
    std::unique_ptr<run::RecordingFile> m_file;
    run::RunFiling m_filing;
    db::NewRun m_run;
    mutable std::mutex m_mutex;  ///< of the next two: the thread of the run writes them
    core::Bytes m_bytes;         ///< its recording
    std::string m_recordingTrouble;
    std::string m_filingTrouble;
    core::RecordingWriter m_writer;
    std::unique_ptr<live::LiveRun> m_live;
    wall::FrameClock m_clock;
    std::optional<std::string> m_outcome;
};

}  // namespace sagara::replay
