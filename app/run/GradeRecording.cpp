#include "app/run/GradeRecording.h"

#include "core/base/Hash.h"
#include "core/exercise/Observe.h"

namespace sagara::run {
namespace {

/// Grades by another mission while a run goes on, as advance does by its own.
class SideGrader {
public:
    SideGrader(const core::World& world, const core::Mission& mission)
        : m_world(world), m_mission(mission), m_grading{core::startAssessment(mission), {}} {}

    void after(const core::State& state, std::span<const core::Event> events) {
        for (const core::Event& e : events) {
            const auto happening = e.ship == 0 ? core::happeningOf(e) : std::nullopt;
            if (happening) core::assess(m_mission, m_grading.assessment, *happening, m_grading.events);
        }
        if (state.tick % core::kTrackEvery_ticks != 0 || m_grading.assessment.closed) return;
        const core::Observation now = core::observe(m_world, state, 0);
        core::assess(m_mission, m_world.path, m_grading.assessment, now, m_grading.events);
        if (core::allTasksDone(m_grading.assessment)) finish(state);
    }
    void finish(const core::State& state) {
        core::closeAssessment(m_mission, m_grading.assessment, core::observe(m_world, state, 0),
                              m_grading.events);
    }
    const core::Grading& grading() const { return m_grading; }

private:
    const core::World& m_world;
    const core::Mission& m_mission;
    core::Grading m_grading;
};

RunSummary gradeFromTrack(const core::World& world, const core::Recording& recording, std::int64_t untilTick,
                          const core::Mission& mission, const std::string& because) {
    const auto track = recording.track(world.ships.size(), world.targets.size());
    const core::Grading grading = core::gradeTrack(mission, world.path, track, recording.events, untilTick);
    RunSummary summary = summarise(world, mission, grading.assessment, grading.events);
    summary.simTime_s = core::timeOfTick(std::min(untilTick, recording.endTick)).seconds();
    summary.stateHash = core::toHex(recording.end ? recording.end->stateHash : 0);
    summary.gradedFrom = "the recorded track: " + because;
    return summary;
}

}  // namespace

RunSummary gradeRecording(const core::World& world, const core::Recording& recording, std::int64_t untilTick,
                          const core::Mission* rubric, const core::AfterTick& after) {
    const core::Mission& mission = rubric ? *rubric : world.mission;
    SideGrader side(world, mission);
    std::vector<core::Event> events;
    auto last = core::replay(world, recording, std::min(untilTick, recording.endTick),
                             [&](const core::State& state, std::span<const core::Command> commands,
                                 std::span<const core::Event> now) {
                                 events.insert(events.end(), now.begin(), now.end());
                                 if (rubric) side.after(state, now);
                                 if (after) after(state, commands, now);
                             });
    if (!last) return gradeFromTrack(world, recording, untilTick, mission, last.error());
    if (rubric) side.finish(*last);
    RunSummary summary = rubric ? summarise(world, mission, side.grading().assessment, side.grading().events)
                                : summarise(world, mission, last->assessment, assessmentEvents(events));
    summary.simTime_s = last->time().seconds();
    summary.stateHash = core::toHex(core::stateHash(*last));
    summary.gradedFrom = "the run itself, to the bit";
    return summary;
}

}  // namespace sagara::run
