#include "core/assess/PassageTasks.h"

#include "core/base/Units.h"

namespace sagara::core {
namespace {

/// Notes: A and B are the last position, once begun.
class GateTask final : public Task {
public:
    GateTask(std::string id, std::string title, Segment gate, NorthEast inside)
        : Task(std::move(id), std::move(title)), m_gate(gate), m_inside(side(inside)) {}

    bool step(const Observation& now, TaskMemory& memory) const override {
        const NorthEast last = memory.begun ? NorthEast{memory.noteA, memory.noteB} : now.position;
        memory.begun = true;
        memory.noteA = now.position.north_m;
        memory.noteB = now.position.east_m;
        return crosses(m_gate, last, now.position) && side(last) == m_inside;
    }

    std::optional<TaskZone> zone() const override { return TaskZone::gate(m_gate.a, m_gate.b); }

private:
    /// On the line itself: the same side for `crosses`.
    bool side(NorthEast p) const { return cross(m_gate.b - m_gate.a, p - m_gate.a) >= 0.0; }

    Segment m_gate;
    bool m_inside;
};

class TransitTask final : public Task {
public:
    TransitTask(std::string id, std::string title, NorthEast to, double within_m)
        : Task(std::move(id), std::move(title)), m_to(to), m_within_m(within_m) {}

    bool step(const Observation& now, TaskMemory&) const override {
        return distance(now.position, m_to) <= m_within_m;
    }

    std::optional<TaskZone> zone() const override { return TaskZone::circle(m_to, m_within_m); }

private:
    NorthEast m_to;
    double m_within_m;
};

}  // namespace

std::unique_ptr<const Task> makeGateTask(std::string id, std::string title, config::Reader& in,
                                         const MissionContext& context) {
    Segment gate;
    const std::size_t count = in.list("between").size();
    if (count != 2) {
        in.problem("between", "names " + std::to_string(count) + " places", "two");
    } else {
        gate = {context.readPlace(in, "between[0]"), context.readPlace(in, "between[1]")};
    }
    const NorthEast inside =
        context.route.waypoints.empty() ? NorthEast{} : context.route.waypoints.front().position;
    return std::make_unique<GateTask>(std::move(id), std::move(title), gate, inside);
}

std::unique_ptr<const Task> makeTransitTask(std::string id, std::string title, config::Reader& in,
                                            const MissionContext& context) {
    const NorthEast to = context.readPlace(in, "to");
    const double within_m = kNauticalMile_m * in.number("within_M", {0.01, 10.0, "M"});
    return std::make_unique<TransitTask>(std::move(id), std::move(title), to, within_m);
}

}  // namespace sagara::core
