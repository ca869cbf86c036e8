#pragma once

#include <vector>

#include "core/exercise/Session.h"
#include "ui/run/ExerciseRun.h"

namespace sagara::test {

/// An exercise without a clock, for windows under test: it goes on when the test says so. Keeps what it was
/// ordered.
class SteppedRun final : public ui::ExerciseRun {
public:
    explicit SteppedRun(std::shared_ptr<const core::World> world, int level = 3)
        : m_world(std::move(world)), m_session(m_world, core::startState(*m_world, level), {}, nullptr) {
        publish();
    }

    void sail(double seconds) {
        for (int i = 0; i < static_cast<int>(seconds / core::kTick_s + 0.5) && !m_session.over(); ++i)
            for (const core::Event& event : m_session.step()) m_events.push_back(event);
        publish();
    }
    std::vector<core::Order> given;
    template <typename Order>
    const Order* last() const {
        return given.empty() ? nullptr : std::get_if<Order>(&given.back());
    }

    const std::shared_ptr<const core::World>& world() const override { return m_world; }
    std::shared_ptr<const core::Snapshot> latest() const override { return m_latest; }
    core::State state() const override { return m_session.state(); }
    Picture toDraw() override { return {m_latest->time(), *m_latest}; }
    std::vector<core::Event> eventsFrom(std::size_t index) const override {
        return {m_events.begin() + static_cast<std::ptrdiff_t>(std::min(index, m_events.size())),
                m_events.end()};
    }
    void start() override { m_running = true; }
    void freeze() override { m_running = false; }
    bool running() const override { return m_running; }
    bool over() const override { return m_session.over(); }
    void setRate(double times) override { m_rate = times; }
    double rate() const override { return m_rate; }
    double lagged_s() const override { return 0.0; }
    void give(std::uint8_t ship, core::Order order) override {
        given.push_back(order);
        m_session.give(ship, std::move(order));
    }
    std::string trouble() const override { return {}; }

private:
    void publish() {
        m_latest = std::make_shared<const core::Snapshot>(core::view(*m_world, m_session.state()));
    }

    std::shared_ptr<const core::World> m_world;
    core::Session m_session;
    std::shared_ptr<const core::Snapshot> m_latest;
    std::vector<core::Event> m_events;
    bool m_running = false;
    double m_rate = 1.0;
};

}  // namespace sagara::test
