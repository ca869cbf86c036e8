#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/exercise/Command.h"
#include "core/exercise/Event.h"
#include "core/exercise/Snapshot.h"

namespace sagara::ui {

/// An exercise as the windows of the station see it and what they may do with it. Whoever owns the run
/// supplies it; it outlives the windows. Nothing here waits: a call takes far less than a frame.
class ExerciseRun {
public:
    virtual ~ExerciseRun() = default;

    virtual const std::shared_ptr<const core::World>& world() const = 0;
    virtual std::shared_ptr<const core::Snapshot> latest() const = 0;
    virtual core::State state() const = 0;  ///< a copy, to look ahead from
    /// What is to be drawn now: between two ticks, evenly. `time` is the picture's.
    struct Picture {
        core::SimTime time;
        core::Snapshot snapshot;
    };
    virtual Picture toDraw() = 0;
    virtual std::vector<core::Event> eventsFrom(std::size_t index) const = 0;

    virtual void start() = 0;
    virtual void freeze() = 0;
    virtual bool running() const = 0;
    virtual bool over() const = 0;
    virtual void setRate(double times) = 0;
    virtual double rate() const = 0;
    virtual double lagged_s() const = 0;
    virtual void give(std::uint8_t ship, core::Order order) = 0;
    /// Anything a person must know: the disk is full, the database cannot be reached. Empty when all is well.
    virtual std::string trouble() const = 0;
};

}  // namespace sagara::ui
