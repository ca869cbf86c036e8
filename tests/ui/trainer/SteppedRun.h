#pragma once

#include "core/exercise/Session.h"
#include "ui/run/ExerciseRun.h"

namespace sagara::test {

/// A run without a thread or a clock: `sail` makes time pass. Orders wait for it, as they do in a frozen run.
class SteppedRun final : public ui::ExerciseRun {
public:
    explicit SteppedRun(std::shared_ptr<const core::World> world, int level = 1);
    void sail(double seconds);
    /// As when the trainer goes back: the state of a moment ago and no event after it.
    void goBackTo(const core::State& state);
    const std::vector<core::Order>& given() const { return m_given; }

    const std::shared_ptr<const core::World>& world() const override { return m_world; }
    std::shared_ptr<const core::Snapshot> latest() const override { return m_latest; }
    core::State state() const override { return m_session->state(); }
    Picture toDraw() override { return {m_latest->time(), *m_latest}; }
    std::vector<core::Event> eventsFrom(std::size_t index) const override;
    void start() override { m_running = true; }
    void freeze() override { m_running = false; }
    bool running() const override { return m_running; }
    bool over() const override { return m_session->over(); }
    void setRate(double times) override { m_rate = times; }
    double rate() const override { return m_rate; }
    double lagged_s() const override { return 0.0; }
    void give(std::uint8_t ship, core::Order order) override;
    std::string trouble() const override { return {}; }

private:
    std::shared_ptr<const core::World> m_world;
    std::unique_ptr<core::Session> m_session;
    std::shared_ptr<const core::Snapshot> m_latest;
    std::vector<core::Event> m_events;
    std::vector<core::Order> m_given;
    bool m_running = false;
    double m_rate = 1.0;
};

}  // namespace sagara::test
