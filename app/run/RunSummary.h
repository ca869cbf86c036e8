#pragma once

#include <string>
#include <vector>

#include "core/exercise/Event.h"
#include "core/exercise/World.h"

namespace sagara::run {

/// One run as people read it: what was done, what it cost. Units of display.
struct RunSummary {
    struct Task {
        std::string id;
        std::string title;
        bool done = false;
        double time_s = 0.0;
    };
    struct Loss {
        std::string id;  ///< of the criterion
        std::string title;
        std::string quantity;
        std::string unit;
        double time_s = 0.0;
        core::NorthEast place;
        core::GeoPoint geo;
        double value = 0.0;
        double limit = 0.0;
        double points = 0.0;
        bool fails = false;
    };
    std::string scenario;
    bool passed = false;
    std::string whyNot;  ///< empty when passed
    double score = 100.0;
    std::vector<Task> tasks;
    std::vector<Loss> losses;
    double simTime_s = 0.0;
    double wallTime_s = 0.0;
    std::string stateHash;
    std::string gradedFrom;
};

/// From the assessment as it stands and the deductions and tasks it reported.
RunSummary summarise(const core::World& world, const core::Mission& mission,
                     const core::Assessment& assessment, const std::vector<core::AssessmentEvent>& reported);

/// The reports of the assessment among the events of a run.
std::vector<core::AssessmentEvent> assessmentEvents(const std::vector<core::Event>& events);

/// {"scenario", "passed", "score", "tasks", "deductions", "sim_time_s", "wall_time_s", "state_hash",
/// "graded_from"}, one line.
std::string toJson(const RunSummary& summary);
/// Result, tasks, deductions, for a terminal; ends with "state-hash: HEX".
std::string toText(const RunSummary& summary);
/// Arrays as the grade table keeps them.
std::string tasksJson(const RunSummary& summary);
std::string deductionsJson(const RunSummary& summary);

/// "12:05" or "1:02:05".
std::string clock(double time_s);

}  // namespace sagara::run
