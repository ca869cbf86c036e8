#pragma once

#include <functional>

#include "app/station/RunLeg.h"
#include "app/station/RunRequest.h"
#include "ui/run/ExerciseRun.h"

namespace sagara::station {

/// An exercise of the station: runs live, is recorded from its first tick, is listed in the database, and can
/// go back to any second of it. Of the thread of the windows, but for `momentForWall`.
class StationRun final : public ui::ExerciseRun {
public:
    /// The error is for the person who chose. `store` outlives the run.
    static core::Result<std::unique_ptr<StationRun>, std::string> open(run::Store& store,
                                                                       const RunRequest& request);
    /// The same of an exercise that is built already; `request.scenario` and `seed` are the world's.
    static core::Result<std::unique_ptr<StationRun>, std::string> open(
        run::Store& store, const RunRequest& request, std::shared_ptr<const core::World> world);
    /// A run that was broken off, from its last saved second; it stands still at first.
    static core::Result<std::unique_ptr<StationRun>, std::string> takeUp(
        run::Store& store, const std::filesystem::path& recording);
    ~StationRun() override;

    const std::shared_ptr<const core::World>& world() const override { return m_leg->world(); }
    std::shared_ptr<const core::Snapshot> latest() const override { return live().latest(); }
    core::State state() const override { return live().state(); }
    Picture toDraw() override;
    std::vector<core::Event> eventsFrom(std::size_t index) const override { return live().eventsFrom(index); }
    void start() override { live().start(); }
    void freeze() override { live().freeze(); }
    bool running() const override { return live().running(); }
    bool over() const override { return live().over() || m_leg->ended(); }
    void setRate(double times) override { live().setRate(times); }
    double rate() const override { return live().rate(); }
    double lagged_s() const override { return live().lagged_s(); }
    void give(std::uint8_t ship, core::Order order) override { live().give(ship, std::move(order)); }
    std::string trouble() const override { return m_leg->trouble(); }

    /// What a display in another thread draws now; each has a clock of its own.
    wall::Moment momentForWall(wall::FrameClock& clock) const;

    /// An assessment counts as it was sailed: it never goes back.
    bool mayGoBack() const { return m_leg->header().runType != "assess"; }
    /// Reads the recording and sails up to ten seconds of it again: to be called in any thread, also when
    /// the run has gone. The error is for the person who asked.
    using WayBack = std::function<core::Result<run::SetBack, std::string>()>;
    /// To a second that has been sailed. The run is frozen, and stays so until it has gone back.
    core::Result<WayBack, std::string> wayBack(std::int64_t second);
    /// The run stands still there. What was sailed since stays in a recording of its own. The error is for
    /// the person who asked; then nothing has changed.
    std::optional<std::string> goBack(run::SetBack there);
    /// Of what was sailed before the run was taken up or went back.
    const std::vector<core::TrackSample>& sailedBefore() const { return m_leg->sailedBefore(); }

    const core::RecordingHeader& header() const { return m_leg->header(); }
    /// Ends the run, writes the end of its recording, grades and files it. Once; the same result after that.
    const run::RunSummary& end() { return m_leg->end(); }
    const std::filesystem::path& recording() const { return m_leg->recording(); }

private:
    StationRun(run::Store& store, std::unique_ptr<RunLeg> leg) : m_store(store), m_leg(std::move(leg)) {}
    live::LiveRun& live() const { return m_leg->live(); }

    run::Store& m_store;
    mutable std::mutex m_mutex;  ///< of m_leg, against momentForWall
    std::unique_ptr<RunLeg> m_leg;
    wall::FrameClock m_clock;
};

}  // namespace sagara::station
