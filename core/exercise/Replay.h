#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/exercise/Recording.h"

namespace sagara::core {

/// The world a recording ran in, from the documents it carries. `hulls`: where those of its vessels may be.
Result<std::shared_ptr<const World>, config::Problems> worldOf(const Recording& recording,
                                                               std::shared_ptr<SeaHulls> hulls = nullptr);

/// A stored state of a recording. Fails when its bytes cannot be read or are not of this world.
Result<State, std::string> readState(const World& world, const Recording::StatePart& part);

/// State of a run at a tick, to the bit: the last stored state not after it, and the commands since. Fails
/// when the recording is of another build, does not reach so far or its states cannot be read.
Result<State, std::string> stateAt(const World& world, const Recording& recording, std::int64_t tick);

/// Runs the whole recording again from its first state. `after` sees every tick. Fails as stateAt does, and
/// when a stored state on the way does not come out the same: it names the first second that differs.
using AfterTick = std::function<void(const State&, std::span<const Command>, std::span<const Event>)>;
Result<State, std::string> replay(const World& world, const Recording& recording, std::int64_t untilTick,
                                  const AfterTick& after);

/// What a mission makes of a run.
struct Grading {
    Assessment assessment;
    std::vector<AssessmentEvent> events;
};

/// Grades the kinematic track and the events of a recording: for a run of another build, or by another
/// mission. Values are those of the track, rounded.
Grading gradeTrack(const Mission& mission, const RoutePath& path, const std::vector<TrackSample>& track,
                   const std::vector<Event>& events, std::int64_t untilTick);

/// A rubric file: {"document": "rubric", "version": 1, "scenario": id, "mission": {..}}, read against the
/// exercise's area, route and lines.
Result<std::shared_ptr<const Mission>, config::Problems> loadRubric(const std::string& name,
                                                                    std::string_view text,
                                                                    const World& world);

}  // namespace sagara::core
