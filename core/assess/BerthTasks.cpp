#include "core/assess/BerthTasks.h"

#include <cmath>

#include "core/base/Angle.h"

namespace sagara::core {
namespace {

/// Notes: A is the heading she lay at.
class SpringOffTask final : public Task {
public:
    SpringOffTask(std::string id, std::string title, std::uint8_t keep, double swing_rad)
        : Task(std::move(id), std::move(title)), m_keep(keep), m_swing_rad(swing_rad) {}

    bool step(const Observation& now, TaskMemory& memory) const override {
        if (!memory.begun) {
            memory.begun = true;
            memory.noteA = now.heading_rad;
        }
        const bool singledUp = (now.linesFast & ~m_keep) == 0;
        const bool held = (now.linesFast & m_keep) != 0;
        return singledUp && held && std::abs(wrapPi(now.heading_rad - memory.noteA)) >= m_swing_rad;
    }

private:
    std::uint8_t m_keep;
    double m_swing_rad;
};

class ClearOfBerthTask final : public Task {
public:
    ClearOfBerthTask(std::string id, std::string title, double distance_m)
        : Task(std::move(id), std::move(title)), m_distance_m(distance_m) {}

    bool step(const Observation& now, TaskMemory&) const override {
        return now.linesOut == 0 && now.clearOfShore_m >= m_distance_m;
    }

private:
    double m_distance_m;
};

}  // namespace

std::unique_ptr<const Task> makeSpringOffTask(std::string id, std::string title, config::Reader& in,
                                              const MissionContext& context) {
    const std::uint8_t keep = context.readLines(in, "keep");
    if (in.sound() && keep == 0) in.problem("keep", "is empty", "the lines to spring off on");
    const double swing_rad = kDegree_rad * in.number("swing_deg", {2.0, 90.0, "deg"});
    return std::make_unique<SpringOffTask>(std::move(id), std::move(title), keep, swing_rad);
}

std::unique_ptr<const Task> makeClearOfBerthTask(std::string id, std::string title, config::Reader& in,
                                                 const MissionContext&) {
    const double distance_m = in.number("distance_m", {1.0, kShoreLimit_m, "m"});
    return std::make_unique<ClearOfBerthTask>(std::move(id), std::move(title), distance_m);
}

}  // namespace sagara::core
