#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/exercise/Recording.h"
#include "core/exercise/Snapshot.h"

namespace sagara::ui {

/// Orders beside the kinematic track, which does not hold them: one for each of its samples.
struct ReplayOrders {
    struct Sample {
        double rudder_rad = 0.0;
        std::array<double, core::kMostShafts> shafts_rps{};
    };
    std::vector<Sample> samples;
    bool verified = false;  ///< the whole run came out as it was recorded
};

/// What became of a run, by its own mission.
struct ReplayResult {
    struct Task {
        std::string title;
        bool done = false;
        double time_s = 0.0;
    };
    struct Loss {
        std::string title;     ///< of the criterion
        std::string quantity;  ///< "speed over ground"
        std::string unit;      ///< "kn"
        double time_s = 0.0;
        double value = 0.0;  ///< in that unit
        double limit = 0.0;
        double points = 0.0;
        bool fails = false;
    };
    bool passed = false;
    std::string whyNot;
    double score = 100.0;
    double passScore = 0.0;
    std::vector<Task> tasks;
    std::vector<Loss> losses;
    std::string gradedFrom;
};

/// A recorded run as the debriefing sees it: what it was, what is to be seen of it at any moment, and a clock
/// that plays it. Whoever owns the recording supplies it. Every call is made from one thread and takes far
/// less than a frame: where the moment asked for has still to be worked out, the kinematic track is shown.
class Replay {
public:
    virtual ~Replay() = default;

    virtual const std::shared_ptr<const core::World>& world() const = 0;
    virtual const core::RecordingHeader& header() const = 0;
    virtual core::SimTime begin() const = 0;
    virtual core::SimTime end() const = 0;
    virtual const std::vector<core::TrackSample>& track() const = 0;
    virtual const std::vector<core::Event>& events() const = 0;
    virtual const std::vector<core::Command>& commands() const = 0;
    /// Targets that the trainer added in the run: they follow those of the world.
    virtual const std::vector<core::TargetLayout>& added() const = 0;
    virtual const ReplayResult& result() const = 0;
    /// Null while they are being worked out, and for good where the run cannot be run again.
    virtual std::shared_ptr<const ReplayOrders> orders() const = 0;

    /// The run can be run again to the bit; otherwise only the kinematic track is shown.
    virtual bool exact() const = 0;
    /// What a person must know of this recording: cut off, of another build. Empty when all is well.
    virtual std::string remark() const = 0;

    struct Picture {
        core::SimTime time;
        core::Snapshot snapshot;
        bool exact = false;  ///< of the run itself; else of the track
    };
    /// What is to be drawn now.
    virtual Picture toDraw() = 0;

    virtual core::SimTime now() const = 0;
    virtual bool playing() const = 0;
    virtual void play() = 0;  ///< at the end: nothing happens
    virtual void pause() = 0;
    virtual double rate() const = 0;
    virtual void setRate(double times) = 0;  ///< kept within kSlowestReplay and kFastestReplay
    virtual void seek(core::SimTime time) = 0;
    /// The state of the moment it stands at, to the bit; none while it plays or is being worked out.
    virtual std::optional<core::State> state() const = 0;
};

inline constexpr double kSlowestReplay = 0.25;
inline constexpr double kFastestReplay = 20.0;

}  // namespace sagara::ui
