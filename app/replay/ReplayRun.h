#pragma once

#include <memory>

#include "app/replay/ExactPlayer.h"
#include "app/replay/OrderScan.h"
#include "app/replay/PlayClock.h"
#include "app/replay/TrackView.h"
#include "ui/debrief/Replay.h"

namespace sagara::replay {

/// A recording that is played: a clock, the run itself where this build can run it again, and the kinematic
/// track for the moments it is not there yet, or at all.
class ReplayRun final : public ui::Replay {
public:
    ReplayRun(std::shared_ptr<const Film> film, ui::ReplayResult result);

    const std::shared_ptr<const core::World>& world() const override { return m_film->world; }
    const core::RecordingHeader& header() const override { return m_film->recording.header; }
    core::SimTime begin() const override { return core::timeOfTick(m_film->beginTick()); }
    core::SimTime end() const override { return core::timeOfTick(m_film->endTick()); }
    const std::vector<core::TrackSample>& track() const override { return m_film->track; }
    const std::vector<core::Event>& events() const override { return m_film->recording.events; }
    const std::vector<core::Command>& commands() const override { return m_film->recording.commands; }
    const std::vector<core::TargetLayout>& added() const override { return m_film->recording.added; }
    const ui::ReplayResult& result() const override { return m_result; }
    std::shared_ptr<const ui::ReplayOrders> orders() const override;
    bool exact() const override { return m_exact && m_exact->trouble().empty(); }
    std::string remark() const override;

    Picture toDraw() override;
    core::SimTime now() const override;
    bool playing() const override;
    void play() override;
    void pause() override;
    double rate() const override { return m_clock.rate(); }
    void setRate(double times) override;
    void seek(core::SimTime time) override;
    std::optional<core::State> state() const override;

    const std::shared_ptr<const Film>& sharedFilm() const { return m_film; }

private:
    void wish();

    std::shared_ptr<const Film> m_film;
    ui::ReplayResult m_result;
    PlayClock m_clock;
    TrackView m_track;
    std::unique_ptr<ExactPlayer> m_exact;
    std::unique_ptr<OrderScan> m_orders;
};

/// Grade of a film by its own mission: from its last state, else from the track.
ui::ReplayResult resultOf(const Film& film);

}  // namespace sagara::replay
