#pragma once

#include <map>
#include <mutex>

#include "app/live/LiveRun.h"
#include "ui/demo/DemoPage.h"
#include "ui/run/ExerciseRun.h"

namespace sagara::station {

/// A run that begins anew as often as one likes and is written nowhere: no recording, no database. One object
/// for all lessons, so that whoever draws it keeps what it has. Of the thread of the windows, but for
/// `momentForWall`.
class DemoRun final : public ui::ExerciseRun {
public:
    /// Frozen at that State; the pilot takes the ship with the first tick.
    void put(std::shared_ptr<const core::World> world, core::State first);

    const std::shared_ptr<const core::World>& world() const override { return m_world; }
    std::shared_ptr<const core::Snapshot> latest() const override { return live()->latest(); }
    core::State state() const override { return live()->state(); }
    Picture toDraw() override;
    /// What a display of that world in another thread draws now; nothing once there is another world.
    std::optional<wall::Moment> momentForWall(const core::World& shown, wall::FrameClock& clock) const;
    std::vector<core::Event> eventsFrom(std::size_t index) const override {
        return live()->eventsFrom(index);
    }
    void start() override { live()->start(); }
    void freeze() override { live()->freeze(); }
    bool running() const override { return live()->running(); }
    bool over() const override { return live()->over(); }
    void setRate(double times) override { live()->setRate(times); }
    double rate() const override { return live()->rate(); }
    double lagged_s() const override { return live()->lagged_s(); }
    void give(std::uint8_t ship, core::Order order) override { live()->give(ship, std::move(order)); }
    std::string trouble() const override { return {}; }

private:
    std::shared_ptr<live::LiveRun> live() const;

    std::shared_ptr<const core::World> m_world;
    mutable std::mutex m_mutex;
    std::shared_ptr<live::LiveRun> m_live;  ///< under m_mutex, and m_world is for momentForWall
    wall::FrameClock m_clock;
};

/// The lessons of the exhibition: a World each, built once, and its first State.
class DemoLessons final : public ui::DemoExercises {
public:
    /// At least one.
    DemoLessons(std::vector<std::shared_ptr<const core::World>> worlds, int level);

    std::size_t count() const override { return m_lessons.size(); }
    std::size_t helmLesson() const override { return m_helmLesson; }
    void begin(std::size_t lesson) override;
    ui::ExerciseRun& run() override { return m_run; }
    const DemoRun& demoRun() const { return m_run; }

private:
    struct Lesson {
        std::shared_ptr<const core::World> world;
        core::State first;
    };
    std::vector<Lesson> m_lessons;
    std::size_t m_helmLesson = 0;
    DemoRun m_run;
};

}  // namespace sagara::station
