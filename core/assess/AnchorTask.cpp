#include "core/assess/AnchorTask.h"

#include <algorithm>
#include <cmath>

#include "core/base/Angle.h"

namespace sagara::core {
namespace {

struct AnchorGoal {
    NorthEast place;
    double within_m;
    double leastCable_m;
    double mostCable_m;
    double speed_mps;
    double still_s;
    double hold_s;
    double weather_rad;
};

bool wholeSecond(SimTime time) { return time.us % 1'000'000 == 0; }

/// Notes: A is the time (s) since when she has stayed about the noted place, which restarts, B since when the
/// anchor has held, less what its jerks cost.
class AnchorTask final : public Task {
public:
    AnchorTask(std::string id, std::string title, const AnchorGoal& goal)
        : Task(std::move(id), std::move(title)), m_goal(goal) {}

    bool step(const Observation& now, TaskMemory& memory) const override {
        const AnchorObservation* anchor = nullptr;
        for (const AnchorObservation& a : now.anchors) {
            if (a.down) anchor = &a;
        }
        const double time_s = now.time.seconds();
        if (!anchor || !memory.begun) {
            memory.begun = anchor != nullptr;
            memory.noteA = memory.noteB = time_s;
            memory.notedPlace = now.position;
            return false;
        }
        // Dragging at this speed the anchor never holds; a jerk of the sea that shifts it by a hand's breadth
        // costs some seconds of the time it has held, not all of it.
        constexpr double kMoved_mps = 0.02;
        if (distance(now.position, memory.notedPlace) > m_goal.speed_mps * m_goal.still_s) {
            memory.noteA = time_s;
            memory.notedPlace = now.position;
        }
        memory.noteB = std::min(time_s, memory.noteB + anchor->dragSpeed_mps / kMoved_mps * kObservedEvery_s);
        if (!wholeSecond(now.time) || now.momentarySpeed_mps > m_goal.speed_mps) return false;
        const double shackleSlack_m = 0.05 * kShackle_m;  // the mark on the cable is read to a twentieth
        return distance(anchor->position, m_goal.place) <= m_goal.within_m &&
               anchor->cableOut_m >= m_goal.leastCable_m - shackleSlack_m &&
               anchor->cableOut_m <= m_goal.mostCable_m + shackleSlack_m &&
               time_s - memory.noteA >= m_goal.still_s && time_s - memory.noteB >= m_goal.hold_s &&
               std::abs(wrapPi(now.heading_rad - now.windFrom_rad)) <= m_goal.weather_rad;
    }

    std::optional<TaskZone> zone() const override { return TaskZone::circle(m_goal.place, m_goal.within_m); }

private:
    AnchorGoal m_goal;
};

}  // namespace

std::unique_ptr<const Task> makeAnchorTask(std::string id, std::string title, config::Reader& in,
                                           const MissionContext& context) {
    AnchorGoal goal{};
    goal.place = context.readPlace(in, "at");
    goal.within_m = in.number("within_m", {1.0, 2000.0, "m"});
    const std::vector<double> shackles = in.numbers("shackles", 2, {0.5, 20.0, "shackles"});
    if (in.sound() && shackles[1] < shackles[0]) in.problem("shackles", "runs downwards", "[least, most]");
    goal.leastCable_m = kShackle_m * shackles[0];
    goal.mostCable_m = kShackle_m * shackles[1];
    goal.speed_mps = kKnot_mps * in.number("speed_kn", {0.05, 3.0, "kn"});
    goal.still_s = in.number("still_s", {1.0, 1800.0, "s"});
    goal.hold_s = in.number("hold_s", {0.0, 1800.0, "s"});
    goal.weather_rad = kDegree_rad * in.number("weather_deg", {5.0, 180.0, "deg"});
    return std::make_unique<AnchorTask>(std::move(id), std::move(title), goal);
}

}  // namespace sagara::core
