#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/assess/Criterion.h"
#include "core/assess/Task.h"

namespace sagara::core {

/// What a trainee is to do and how it is graded. Immutable.
struct Mission {
    std::string objective;
    std::string competenceCode;  ///< of the school's standard, such as an STCW table
    std::string briefing;
    std::vector<std::unique_ptr<const Task>> tasks;  ///< in the order they are done
    std::vector<std::unique_ptr<const Criterion>> criteria;
    double passScore = 70.0;
};

/// "mission" of a scenario document.
Mission readMission(config::Reader& in, const MissionContext& context);

/// Progress of the mission. Part of State; the deductions themselves are events and kept by the recorder.
struct Assessment {
    std::vector<TaskMemory> tasks;
    std::vector<CriterionMemory> criteria;
    RouteProgress route;
    std::uint32_t currentTask = 0;  ///< tasks.size() when all are done
    bool failed = false;            ///< a criterion that fails the run was broken
    bool closed = false;            ///< graded to the end

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.tasks, self.criteria, self.route, self.currentTask, self.failed, self.closed);
    }
};

/// A deduction or a task done, as the assessment reports it.
struct AssessmentEvent {
    enum class Kind : std::uint8_t { TaskDone, Deduction, Failed };
    Kind kind = Kind::TaskDone;
    std::uint32_t index = 0;  ///< of the task or criterion
    Deduction deduction;      ///< for TaskDone only its time and place are set
};

Assessment startAssessment(const Mission& mission);
/// One grading step. Events are appended to `out`.
void assess(const Mission& mission, const RoutePath& path, Assessment& state, const Observation& now,
            std::vector<AssessmentEvent>& out);
void assess(const Mission& mission, Assessment& state, const Happening& happening,
            std::vector<AssessmentEvent>& out);
/// Moves the progress along the route on to where the ship is now.
void follow(const RoutePath& path, NorthEast position, RouteProgress& progress);
/// What the mission allows a ship here, for displays and reports.
Limits limitsAt(const Mission& mission, const Observation& now, const RouteProgress& route);
/// Ends open episodes; after this nothing is graded any more.
void closeAssessment(const Mission& mission, Assessment& state, const Observation& last,
                     std::vector<AssessmentEvent>& out);

/// 0 to 100: what the criteria have left.
double scoreOf(const Assessment& state);
bool allTasksDone(const Assessment& state);
bool passed(const Mission& mission, const Assessment& state);

}  // namespace sagara::core
