#pragma once

#include <cstdint>
#include <string>

#include "core/base/Planar.h"
#include "core/base/SimTime.h"
#include "core/world/Contact.h"

namespace sagara::core {

/// Kinds of what happens in a tick. Recordings hold the number: new kinds go to the end.
enum class EventKind : std::uint8_t {
    LineLetGo,       ///< index: line
    LineIn,          ///< index: line
    LineParted,      ///< index: line; value: tension, N
    AnchorLetGo,     ///< index: anchor; place: of the hawse; value: speed along the heading over ground, m/s
    AnchorOnBottom,  ///< index: anchor; place: of the anchor
    AnchorDragging,  ///< index: anchor; value: pull, N
    AnchorHome,      ///< index: anchor
    CableParted,     ///< index: anchor
    Contact,         ///< contact: with what; value: approach speed, m/s; energy; index: other ship
    Grounding,       ///< value: speed through the water, m/s
    Afloat,          ///< off the ground again
    TaskDone,        ///< index: task
    Deduction,       ///< index: criterion; value, limit, points
    MissionFailed,   ///< index: criterion
    Finished,        ///< the exercise is over
    ScenarioEvent,   ///< index: event of the scenario
    FaultCame,       ///< index: Fault; value: number of the engine, pumps that fail
    FaultMended,     ///< index: Fault; value: number of the engine
    TargetAppeared,  ///< index: target
    TargetGone,      ///< index: target
    LevelChanged,    ///< index: level
    Stopped,       ///< a value was not finite: the exercise cannot go on; index: component, see componentName
    NoteMade,      ///< by the trainer; text; value: 1 for a bookmark
    Reported,      ///< by the trainee; index: ReportKind; place: of the own ship
    TargetMoved,   ///< by the trainer, to another place; index: target
    MotionsFreed,  ///< for the classroom; index: bits of FreeMotion
    GreenWater,    ///< comes over the bow; value: above the deck there, m
    Slam           ///< of the forefoot; value: relative velocity, m/s
};
inline constexpr EventKind kLastEventKind = EventKind::Slam;
const char* eventKindName(EventKind kind);

/// One thing that happened. What a kind uses is said above. The archive leaves the text out: recordings keep
/// it beside, see SecondChunk.
struct Event {
    std::int64_t tick = 0;
    EventKind kind = EventKind::Finished;
    std::uint8_t ship = 0;
    ContactKind contact = ContactKind::Fender;
    std::int32_t index = 0;
    NorthEast place;
    double value = 0.0;
    double limit = 0.0;
    double points = 0.0;
    double energy_J = 0.0;
    std::string text;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.tick, self.kind, self.ship, self.contact, self.index, self.place, self.value, self.limit,
           self.points, self.energy_J);
    }
    SimTime time() const { return timeOfTick(tick); }
};

/// Name of the part of a ship's state that EventKind::Stopped points at.
const char* componentName(std::int32_t index);

}  // namespace sagara::core
