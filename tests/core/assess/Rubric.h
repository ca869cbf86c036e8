#pragma once

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/assess/Mission.h"

namespace sagara::core::test {

/// What rubrics of these tests can name: a route north over B and C, then east to D; places "mark",
/// "gate-west", "gate-east"; lines "head", "stern", "spring".
class Rubric {
public:
    Rubric();
    const RoutePath& path() const { return m_path; }
    /// Each throws with the problems when the text has any.
    std::unique_ptr<const Task> task(const std::string& json) const;
    std::unique_ptr<const Criterion> criterion(const std::string& json) const;
    Mission mission(const std::string& json) const;
    /// Problems of one criterion or task, one a line.
    std::string problemsOfCriterion(const std::string& json) const;
    std::string problemsOfTask(const std::string& json) const;

private:
    MissionContext context() const { return {m_area, m_route, m_path, {"head", "stern", "spring"}}; }

    Area m_area;
    Route m_route;
    RoutePath m_path;
};

/// The beginning of every criterion: weight 10, a breach 4.
std::string terms(const std::string& kindAndMore);

inline SimTime at(double time_s) { return {std::llround(time_s * 1e6)}; }

/// One criterion in the middle of a run.
class Judge {
public:
    explicit Judge(const std::string& json) : criterion(Rubric().criterion(json)) {}
    explicit Judge(const char* json) : Judge(std::string(json)) {}

    Observation now;      ///< of the next look
    RouteProgress route;  ///< of the next look
    CriterionMemory memory;
    std::vector<Deduction> deductions;
    std::unique_ptr<const Criterion> criterion;

    void look(double time_s) { look(at(time_s)); }
    void look(SimTime time) {
        now.time = time;
        criterion->observe(now, route, memory, deductions);
    }
    void happens(const Happening& happening) { criterion->happened(happening, memory, deductions); }
    void close() { criterion->close(now.time, memory, deductions); }
    /// Whether one look at what is, taken by itself, is a breach.
    bool breaks();
};

}  // namespace sagara::core::test
