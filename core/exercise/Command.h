#pragma once

#include <cstdint>
#include <variant>

#include "core/bridge/ShipOrders.h"
#include "core/exercise/InstructorOrders.h"
#include "core/exercise/TargetOrders.h"

namespace sagara::core {

/// Every order there is. Recordings hold the index: new kinds go to the end.
using Order =
    std::variant<HelmOrder, TelegraphOrder, ShaftOrder, AutopilotOrder, PilotOrder, LineOrder, AnchorOrder,
                 WeatherOrder, FaultOrder, TargetOrder, DifficultyOrder, TriggerOrder, FinishOrder, NoteOrder,
                 ReportOrder, AddTargetOrder, MoveTargetOrder, SteerTargetOrder, RouteTargetOrder,
                 FreezeMotionOrder, ThrusterOrder, PitchOrder, AzimuthOrder>;

/// The only way into a running exercise: an order, the own ship it is for (or none) and the tick it is
/// carried out in.
struct Command {
    std::int64_t tick = 0;
    std::uint8_t ship = 0;
    Order order;

    template <typename Archive, typename Self>
    static void fields(Archive& ar, Self& self) {
        ar(self.tick, self.ship, self.order);
    }
};

}  // namespace sagara::core
